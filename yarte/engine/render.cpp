#include "yarte/engine/render.h"

#include "yarte/engine/render_job.h"

#include <algorithm>
#include <utility>

#include <sched.h>
#include <unistd.h>

namespace yarte {

int availableCores() {
    cpu_set_t cores;
    if (sched_getaffinity(0, sizeof cores, &cores) == 0) return std::max(1, CPU_COUNT(&cores));
    // A machine with more cores than cpu_set_t has bits.
    return static_cast<int>(std::max(1L, sysconf(_SC_NPROCESSORS_ONLN)));
}

bool RenderJob::renderNext(int worker, std::vector<Colour>& pixels) const {
    const std::optional<std::size_t> index = queue.claim(worker);
    if (!index) return false;
    const Tile tile = queue.tiles()[*index];
    RayCounts rays;
    const auto width = static_cast<std::size_t>(tile.width());
    pixels.resize(width * static_cast<std::size_t>(tile.height()));
    renderTile(tile, pixels.data(), width, rays);
    framebuffer.put(tile, pixels.data());
    queue.finish(*index, rays);
    return true;
}

std::optional<Rendering> render(const RenderOptions& options, const TileFunction& renderTile,
                                const ProgressFunction& progress) {
    Framebuffer framebuffer(options.region, options.tileSide);
    TileQueue queue(TileList(options.region, options.tileSide));
    const RenderJob job{renderTile, progress, queue, framebuffer};
    int workers = static_cast<int>(std::min(static_cast<std::size_t>(options.workers), queue.tiles().size()));
    bool finished = false;
    switch (options.mode) {
    case RenderMode::serial:
        workers = 0;
        finished = renderSerial(job);
        break;
    case RenderMode::processes: finished = renderInProcesses(job, workers); break;
    case RenderMode::threads: finished = renderInThreads(job, workers); break;
    }
    if (!finished) return std::nullopt;
    return Rendering{std::move(framebuffer), queue.rays(), workers};
}

} // namespace yarte
