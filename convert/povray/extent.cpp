#include "convert/povray/extent.h"

#include "convert/surround.h"

#include <algorithm>
#include <cmath>
#include <variant>

namespace yarte::convert::povray {

double extentOf(const Scene& scene) { return surroundOf(scene).longestSide(); }

double worldScaleFor(double extent, double least) {
    if (!(extent > 0) || !std::isfinite(extent)) return 1;
    return std::exp2(std::clamp(std::ceil(std::log2(least / extent)), -1000.0, 1000.0));
}

double worldScaleOf(const Scene& scene) {
    const bool hasPlanes = std::ranges::any_of(
        scene.bodies, [](const Body& body) { return std::holds_alternative<Plane>(body.shape); });
    return hasPlanes ? worldScaleFor(extentOf(scene), 250) : worldScaleFor(extentOf(scene));
}

} // namespace yarte::convert::povray
