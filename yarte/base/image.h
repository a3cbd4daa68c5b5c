// Pictures in linear light, row 0 on top. Whoever made them owns the pixels.
#pragma once

#include "yarte/base/colour.h"

#include <cstddef>
#include <functional>
#include <utility>

namespace yarte {

struct ImageView {
    int width = 0, height = 0;
    const Colour* pixels = nullptr; ///< width*height, rows from the top, no padding

    const Colour& at(int x, int y) const {
        return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                      static_cast<std::size_t>(x)];
    }
};

/// A picture that gives its rows one at a time, so that it need not lie in memory as a whole.
struct ImageRows {
    int width = 0, height = 0;
    std::function<const Colour*(int y)> row; ///< `width` pixels, there until the next call

    ImageRows(int w, int h, std::function<const Colour*(int y)> rows)
        : width(w), height(h), row(std::move(rows)) {}
    ImageRows(ImageView image) // any picture can be read so
        : ImageRows(image.width, image.height, [image](int y) { return &image.at(0, y); }) {}
};

} // namespace yarte
