#include "yarte/engine/process_pool.h"
#include "yarte/engine/render_job.h"

#include <fmt/format.h>

#include <set>

namespace yarte {

bool renderInProcesses(const RenderJob& job, int workers) {
    const auto work = [&job](int worker) {
        std::vector<Colour> pixels;
        while (job.renderNext(worker, pixels)) {
        }
    };
    std::set<std::size_t> diedOnce; // tiles
    int diedWithoutTile = 0;

    // A worker may die at any time: its tile is done again by whoever is free, and a new worker takes its
    // place, so the last one to leave has seen that no tile waits. A tile that kills twice would kill for
    // ever; that a worker was stopped is no fault of its tile.
    const auto replace = [&](const ProcessPool::Ending& ending, ProcessPool& pool) {
        if (const auto index = job.queue.putBack(ending.worker)) {
            const Tile tile = job.queue.tiles()[*index];
            if (!ending.wasStopped && !diedOnce.insert(*index).second)
                throw RenderError(fmt::format("tile ({},{})-({},{}): its worker died twice ({})", tile.x0,
                                              tile.y0, tile.x1, tile.y1, ending.text()));
        } else if (++diedWithoutTile > 2 * workers) { // also counts those killed between two tiles
            throw RenderError(fmt::format("workers keep dying before they take a tile ({})", ending.text()));
        }
        pool.start(ending.worker, work);
    };

    ProcessPool pool;
    for (int worker = 0; worker < workers; ++worker) pool.start(worker, work);
    while (!pool.empty()) {
        for (const ProcessPool::Ending& ending : pool.wait(progressInterval))
            if (!ending.good()) replace(ending, pool);
        if (!job.report()) return false;
    }
    return true;
}

} // namespace yarte
