// render: a picture, tile by tile, in this process, in processes forked from it, or in threads: the paper has
// both of the parallel forms. Every way gives the same bytes, because a pixel depends on nothing but its
// place.
#pragma once

#include "yarte/engine/framebuffer.h"
#include "yarte/engine/journal.h"
#include "yarte/engine/render_error.h"
#include "yarte/engine/tile_costs.h"
#include "yarte/trace/render_tile.h"

#include <cstddef>
#include <functional>
#include <optional>

namespace yarte {

enum class RenderMode {
    serial,    ///< in this process and thread: the reference
    processes, ///< survives the death of a worker
    threads,
};

struct RenderOptions {
    Tile region; ///< of the image; not empty
    int tileSide = 32;
    RenderMode mode = RenderMode::processes;
    int workers = 1; ///< processes or threads wanted, >= 1; no more are started than there are tiles
    Journal* journal =
        nullptr; ///< if not null, tiles that it holds are taken from it, and others added to it
};

/// What renderTile of the tracer does, with its world bound; it may take RayCounts instead. Called by several
/// threads or processes at once.
using TileFunction = std::function<void(Tile, Colour* pixels, std::size_t stride, TileCosts&)>;

struct RenderProgress {
    std::size_t done = 0, total = 0; ///< tiles
};

/// Called in the caller's thread about ten times a second, or more often; returning false stops the render.
/// Called once more when all is done, where that makes no difference. May be empty.
using ProgressFunction = std::function<bool(RenderProgress)>;

struct Rendering {
    Framebuffer framebuffer;
    RayCounts rays;
    TraceTimes times;               ///< zeros unless the tile function measures
    int workers = 0;                ///< processes or threads used; 0 in serial mode
    std::size_t damagedRecords = 0; ///< of the journal; their tiles were rendered
};

/// The cores this process may run on, at least 1.
int availableCores();

/// The rendered region; nothing if `progress` stopped it. No worker is left in any case.
/// Throws RenderError, std::bad_alloc, or in serial and threads mode what `render` throws.
std::optional<Rendering> render(const RenderOptions&, const TileFunction& render,
                                const ProgressFunction& progress);

} // namespace yarte
