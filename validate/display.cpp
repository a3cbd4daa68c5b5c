#include "validate/display.h"

#include "validate/metrics.h"
#include "yarte/base/srgb.h"

#include <algorithm>
#include <cmath>

namespace yarte::validate {

namespace {

/// Clamped to [0, 1]; nan is 0.
double clamped(double v) { return std::min(std::max(0.0, v), 1.0); }

template <class ColourAt>
DisplayPicture fill(int width, int height, ColourAt colourAt) {
    DisplayPicture picture{width, height, {}};
    picture.rgb.reserve(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const Colour colour = colourAt(x, y);
            for (const double v : {colour.r, colour.g, colour.b})
                picture.rgb.push_back(static_cast<std::uint8_t>(std::lround(255 * clamped(v))));
        }
    return picture;
}

double encoded(double v) { return srgbFromLinear(clamped(v)); }

/// 0 for errors up to 2^-17 (half a 16-bit step), 1 for errors from 1.
double logarithmic(double error) { return clamped(1 + std::log2(error) / 17); }

} // namespace

DisplayPicture displayPicture(ImageView image) {
    return fill(image.width, image.height, [&](int x, int y) {
        const Colour c = image.at(x, y);
        return Colour{encoded(c.r), encoded(c.g), encoded(c.b)};
    });
}

DisplayPicture differencePicture(ImageView a, ImageView b, double threshold) {
    return fill(a.width, a.height, [&](int x, int y) {
        const double error = pixelError(a.at(x, y), b.at(x, y));
        const double level = logarithmic(error);
        if (error <= threshold) return Colour{level, level, level};
        return Colour{0.55 + 0.45 * level, level, 0.1};
    });
}

} // namespace yarte::validate
