#include "convert/povray/sdl/reflectance.h"

#include <algorithm>
#include <cmath>

namespace yarte::convert::povray::sdl {
namespace {

double fresnel(double cosine, double index) {
    const double sine2 = (1 - cosine * cosine) / (index * index);
    if (sine2 >= 1) return 1;
    const double refracted = std::sqrt(1 - sine2);
    const double s = (cosine - index * refracted) / (cosine + index * refracted);
    const double p = (index * cosine - refracted) / (index * cosine + refracted);
    return (s * s + p * p) / 2;
}

} // namespace

double phongExponent(double roughness) { return roughness == 0 ? 0 : std::max(0.0, 1 / (4 * roughness)); }

double meanFalloff(double falloff) {
    // Of a ball seen from afar, the part 2 cos d(cos) is seen at that angle.
    const double f = std::max(0.0, falloff);
    return 2 / ((f + 1) * (f + 2));
}

double meanFresnel(double index) {
    if (!(index > 0) || !std::isfinite(index)) return 0;
    constexpr int steps = 256;
    double sum = 0;
    for (int i = 0; i < steps; ++i) {
        const double cosine = (i + 0.5) / steps;
        sum += fresnel(cosine, index) * 2 * cosine / steps;
    }
    return sum;
}

} // namespace yarte::convert::povray::sdl
