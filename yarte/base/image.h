// ImageView: a picture in linear light, row 0 on top. Whoever made it owns the pixels.
#pragma once

#include "yarte/base/colour.h"

#include <cstddef>

namespace yarte {

struct ImageView {
    int width = 0, height = 0;
    const Colour* pixels = nullptr; ///< width*height, rows from the top, no padding

    const Colour& at(int x, int y) const {
        return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                      static_cast<std::size_t>(x)];
    }
};

} // namespace yarte
