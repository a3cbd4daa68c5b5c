// Picture: an image that owns its pixels, in linear light, row 0 on top.
#pragma once

#include "yarte/base/image.h"

#include <vector>

namespace yarte::validate {

/// A pixel's place, from 0, row 0 on top.
struct Pixel {
    int x = 0, y = 0;
    friend constexpr bool operator==(Pixel, Pixel) = default;
};

struct Picture {
    int width = 0, height = 0;
    std::vector<Colour> pixels;

    ImageView view() const { return {width, height, pixels.data()}; }
};

inline bool haveOneSize(const Picture& a, const Picture& b) {
    return a.width == b.width && a.height == b.height;
}

/// The picture with every value multiplied by `factor`.
inline Picture scaled(Picture picture, double factor) {
    for (Colour& colour : picture.pixels) colour = colour * factor;
    return picture;
}

} // namespace yarte::validate
