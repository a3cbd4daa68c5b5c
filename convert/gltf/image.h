// The average colour of an image file: what is left of a texture.
#pragma once

#include "yarte/base/colour.h"

#include <string>
#include <string_view>

namespace yarte::convert::gltf {

struct ImageAverage {
    Colour linear{1, 1, 1}; ///< of the colours that the sRGB values mean
    Colour raw{1, 1, 1};    ///< of the values themselves, for textures that are no colours
    double alpha = 1;
    std::string problem; ///< why there is none (all is 1 then); empty: there is
};

/// Larger images are not decoded: a file of some bytes must not ask for all memory.
inline constexpr std::size_t maxImagePixels = std::size_t{1} << 26;

/// Of a PNG or JPEG file, each pixel counting once.
ImageAverage averageOf(std::string_view bytes);

} // namespace yarte::convert::gltf
