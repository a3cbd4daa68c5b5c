// The transfer function of sRGB (IEC 61966-2-1), for values in [0, 1].
#pragma once

#include <cmath>

namespace yarte {

inline double srgbFromLinear(double v) {
    return v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055;
}

inline double linearFromSrgb(double v) {
    return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
}

} // namespace yarte
