// Supersampling: pixels that are means of several rays (antialiasing).
#pragma once

#include "yarte/trace/render_tile.h"

#include <functional>

namespace yarte {

/// The most rays along a pixel's side.
inline constexpr int maxSamples = 256;

/// Writes a tile's pixels as the means of samples x samples pixels of an image so many times as wide and
/// high, whose tiles `renderFine` writes: a box filter over rays in a fixed square pattern.
void supersample(int samples, Tile, Colour* pixels, std::size_t stride,
                 const std::function<void(Tile, Colour* pixels, std::size_t stride)>& renderFine);

} // namespace yarte
