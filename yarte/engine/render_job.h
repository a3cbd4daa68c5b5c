// RenderJob: what the three ways to render have in common.
#pragma once

#include "yarte/engine/render.h"
#include "yarte/engine/tile_queue.h"

#include <chrono>
#include <vector>

namespace yarte {

/// The longest time between two calls of the progress function, unless a single tile takes longer in serial
/// mode.
inline constexpr std::chrono::milliseconds progressInterval{100};

struct RenderJob {
    const TileFunction& renderTile;
    const ProgressFunction& progress;
    TileQueue& queue;
    Framebuffer& framebuffer;

    /// Renders one more tile as `worker`; false if none waits. `pixels` is the worker's own, kept between
    /// calls.
    bool renderNext(int worker, std::vector<Colour>& pixels) const;

    /// Tells how far the render is; false if it must stop.
    bool report() const { return !progress || progress({queue.finishedCount(), queue.tiles().size()}); }
};

// Each returns false if the progress function stopped it.
bool renderSerial(const RenderJob&);
bool renderInProcesses(const RenderJob&, int workers);
bool renderInThreads(const RenderJob&, int workers);

} // namespace yarte
