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
    TileCosts costs;
    const auto width = static_cast<std::size_t>(tile.width());
    pixels.resize(width * static_cast<std::size_t>(tile.height()));
    renderTile(tile, pixels.data(), width, costs);
    framebuffer.put(tile, pixels.data());
    queue.finish(*index, costs);
    return true;
}

namespace {

/// Takes tiles from a journal, and adds to it those that have been finished since.
class JournalKeeper {
public:
    JournalKeeper(Journal* journal, TileQueue& queue, Framebuffer& framebuffer)
        : journal_(journal), queue_(queue), framebuffer_(framebuffer) {
        if (!journal_) return;
        isKept_.resize(queue_.tiles().size());
        damaged_ = journal_->readTiles([this](std::size_t tile, const RayCounts& rays, const Colour* pixels) {
            if (isKept_[tile]) return;
            framebuffer_.put(queue_.tiles()[tile], pixels);
            queue_.finish(tile, {rays, {}});
            isKept_[tile] = true;
        });
    }

    void keep() {
        if (!journal_) return;
        const std::size_t end = queue_.dealtCount();
        while (begin_ < end && isKept_[begin_]) ++begin_;
        for (std::size_t tile = begin_; tile < end; ++tile) {
            if (isKept_[tile]) continue;
            const auto costs = queue_.costsOf(tile);
            if (!costs) continue;
            const Tile place = queue_.tiles()[tile];
            pixels_.resize(static_cast<std::size_t>(place.width()) *
                           static_cast<std::size_t>(place.height()));
            framebuffer_.get(place, pixels_.data());
            journal_->add(tile, *costs, pixels_.data());
            isKept_[tile] = true;
        }
    }
    /// The last call.
    void close() {
        if (!journal_) return;
        keep();
        journal_->flush();
    }

    std::size_t damaged() const { return damaged_; }

private:
    Journal* journal_;
    TileQueue& queue_;
    Framebuffer& framebuffer_;
    std::vector<bool> isKept_;
    std::size_t begin_ = 0; ///< all tiles before it are kept
    std::vector<Colour> pixels_;
    std::size_t damaged_ = 0;
};

} // namespace

std::optional<Rendering> render(const RenderOptions& options, const TileFunction& renderTile,
                                const ProgressFunction& progress) {
    Framebuffer framebuffer(options.region, options.tileSide);
    TileQueue queue(TileList(options.region, options.tileSide));
    JournalKeeper journal(options.journal, queue, framebuffer);
    const ProgressFunction keepAndReport = [&](RenderProgress done) {
        journal.keep();
        return !progress || progress(done);
    };
    const RenderJob job{renderTile, keepAndReport, queue, framebuffer};
    int workers = static_cast<int>(std::min(static_cast<std::size_t>(options.workers), queue.tiles().size()));
    bool finished = false;
    try {
        switch (options.mode) {
        case RenderMode::serial:
            workers = 0;
            finished = renderSerial(job);
            break;
        case RenderMode::processes: finished = renderInProcesses(job, workers); break;
        case RenderMode::threads: finished = renderInThreads(job, workers); break;
        }
    } catch (...) {
        journal.close();
        throw;
    }
    journal.close();
    if (!finished) return std::nullopt;
    // Whatever was counted: a worker that is killed right after a tile does not count it, and of a picture
    // that was kept whole there was nothing to do.
    if (progress) progress({queue.tiles().size(), queue.tiles().size()});
    const TileCosts costs = queue.costs();
    return Rendering{std::move(framebuffer), costs, costs.times, workers, journal.damaged()};
}

} // namespace yarte
