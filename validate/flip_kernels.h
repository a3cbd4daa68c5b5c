// FLIP's filters for a viewing distance: what the eye resolves of each opponent colour, and detectors of
// edges and points [Andersson20].
#pragma once

#include "validate/flip_filter.h"

namespace yarte::validate::flip {

struct Kernels {
    explicit Kernels(double pixelsPerDegree);

    std::size_t maxRadius = 0;
    Kernel luminance, redGreen;                  ///< contrast sensitivity: used along both directions
    Kernel blueYellow[2], blueYellowWeighted[2]; ///< a sum of two: columns by the first, rows by the second
    Kernel gauss, edge, point;                   ///< a Gaussian and its first two derivatives
};

} // namespace yarte::validate::flip
