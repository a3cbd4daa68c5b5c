#include "convert/povray/extent.h"

#include "convert/surround.h"

#include <algorithm>
#include <cmath>

namespace yarte::convert::povray {

double extentOf(const Scene& scene) { return surroundOf(scene).longestSide(); }

double worldScaleFor(double extent) {
    if (!(extent > 0) || !std::isfinite(extent)) return 1;
    return std::exp2(std::clamp(std::ceil(std::log2(1e5 / extent)), -1000.0, 1000.0));
}

} // namespace yarte::convert::povray
