// Hits as text: what `yarte --hits` writes; see yarte/README.md.
#pragma once

#include "yarte/trace/camera_hits.h"

#include <span>
#include <string>

namespace yarte {

/// A line for each pixel of the region, row by row, below one of names; numbers read back to the same bits.
std::string hitsText(Tile region, std::span<const CameraHit>);

} // namespace yarte
