// The colour spaces of FLIP, all relative to the white (1, 1, 1) of linear sRGB. Constants from
// [Andersson20] Andersson, Nilsson, Akenine-Moller, Oskarsson, Astrom, Fairchild: "FLIP: A Difference
// Evaluator for Alternating Images", Proc. ACM Comput. Graph. Interact. Tech. 3(2), 2020.
#pragma once

#include "yarte/base/colour.h"
#include "yarte/base/vec3.h"

#include <algorithm>
#include <cmath>

namespace yarte::validate::flip {

/// CIE XYZ divided by the D65 white's.
constexpr Vec3 xyzFromRgb(Colour c) {
    constexpr double xWhite = 0.950428545, zWhite = 1.088900371;
    return {(10135552.0 * c.r + 8788810.0 * c.g + 4435075.0 * c.b) / 24577794.0 / xWhite,
            (2613072.0 * c.r + 8788810.0 * c.g + 887015.0 * c.b) / 12288897.0,
            (1425312.0 * c.r + 8788810.0 * c.g + 70074185.0 * c.b) / 73733382.0 / zWhite};
}

/// Linear RGB, the inverse of xyzFromRgb by Cramer's rule on its columns.
constexpr Colour rgbFromXyz(Vec3 v) {
    constexpr Vec3 red = xyzFromRgb({1, 0, 0}), green = xyzFromRgb({0, 1, 0}), blue = xyzFromRgb({0, 0, 1});
    constexpr double volume = dot(red, cross(green, blue));
    constexpr Vec3 r = cross(green, blue) / volume, g = cross(blue, red) / volume,
                   b = cross(red, green) / volume;
    return {dot(r, v), dot(g, v), dot(b, v)};
}

constexpr Colour clampedToDisplay(Colour c) {
    const auto clamped = [](double v) { return std::min(std::max(v, 0.0), 1.0); };
    return {clamped(c.r), clamped(c.g), clamped(c.b)};
}

/// A linear opponent space: Y luminance, Cx red-green, Cz blue-yellow.
constexpr Vec3 ycxczFromXyz(Vec3 v) { return {116 * v.y - 16, 500 * (v.x - v.y), 200 * (v.y - v.z)}; }

constexpr Vec3 xyzFromYcxcz(Vec3 v) {
    const double y = (v.x + 16) / 116;
    return {y + v.y / 500, y, y - v.z / 200};
}

/// The cube root of t in [0.008, 1.1] to a few units in the last place: Halley's iteration from a straight
/// line that is off by less than 30 %, which three steps turn into 1e-2, 1e-6 and nothing. (std::cbrt takes
/// half of FLIP's time.)
constexpr double cubeRoot(double t) {
    const auto halley = [t](double root) {
        const double cube = root * root * root;
        return root * (cube + 2 * t) / (2 * cube + t);
    };
    return halley(halley(halley(0.25 + 0.8 * t)));
}

/// CIELAB of a white-normalised XYZ colour, a and b scaled by 0.01 L: colours of dark surfaces count less
/// (Hunt).
constexpr Vec3 huntLabFromXyz(Vec3 v) {
    // Below the knee the cube root goes on as its tangent. Without a branch compilers make vector code of it.
    const auto f = [](double t) {
        constexpr double delta = 6.0 / 29, knee = delta * delta * delta;
        return cubeRoot(std::max(t, knee)) + std::min(t - knee, 0.0) / (3 * delta * delta);
    };
    const double fx = f(v.x), fy = f(v.y), fz = f(v.z);
    const double lightness = 116 * fy - 16;
    return {lightness, 0.01 * lightness * 500 * (fx - fy), 0.01 * lightness * 200 * (fy - fz)};
}

/// The HyAB distance: city block in lightness, Euclidean in chroma.
inline double hyab(Vec3 a, Vec3 b) {
    return std::abs(a.x - b.x) + std::sqrt((a.y - b.y) * (a.y - b.y) + (a.z - b.z) * (a.z - b.z));
}

} // namespace yarte::validate::flip
