// The tracer over lanes: packets of rays on whatever vector instructions the machine has, with the bits of
// Whitted.
#pragma once

#include "yarte/trace/camera_hits.h"
#include "yarte/trace/render_tile.h"

#include <string>
#include <vector>

namespace yarte::trace {

/// As renderTile, on the best instruction set of this machine; adds to the ticks of `times`, if given.
void renderTileInLanes(const World&, Tile, Colour* pixels, std::size_t stride, RayCounts&, TraceTimes* times);

/// As cameraHits, by the same kernels; `to` has room for each pixel of the tile.
void cameraHitsInLanes(const World&, Tile, CameraHit* to);

/// The instruction sets that this machine can run, best first ("AVX3", "AVX2", "SSE4", ...).
std::vector<std::string> laneTargets();

/// Until called again, renders use this one of laneTargets(); "" restores the choice. For tests and
/// measurements.
void forceLaneTarget(const std::string& name);

} // namespace yarte::trace
