// Supersampling: pixels that are means of several rays (antialiasing).
#pragma once

#include "yarte/trace/render_tile.h"

namespace yarte {

/// The most rays along a pixel's side.
inline constexpr int maxSamples = 256;

/// As renderTile, for pixels that are the means of samples x samples of the world's: of a world that is built
/// for an image so many times as wide and high. That is a box filter over rays in a fixed square pattern.
void renderTileSupersampled(const World& fine, int samples, Tile, Colour* pixels, std::size_t stride,
                            RayCounts&);

} // namespace yarte
