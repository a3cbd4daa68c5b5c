// Bounds: an axis-parallel box around something.
#pragma once

#include "yarte/base/frame.h"
#include "yarte/base/vec3.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace yarte::trace {

struct Bounds {
    static constexpr double infinity = std::numeric_limits<double>::infinity();
    Vec3 low{infinity, infinity, infinity}, high{-infinity, -infinity, -infinity};

    bool isEmpty() const { return low.x > high.x; }
    void add(Vec3 p) { add(Bounds{p, p}); }
    void add(const Bounds& b) {
        low = {std::min(low.x, b.low.x), std::min(low.y, b.low.y), std::min(low.z, b.low.z)};
        high = {std::max(high.x, b.high.x), std::max(high.y, b.high.y), std::max(high.z, b.high.z)};
    }
};

/// Of a circle with the given unit normal: along each axis it reaches radius * sin(angle between axis and
/// normal).
inline Bounds boundsOfCircle(Vec3 centre, double radius, Vec3 normal) {
    const auto reach = [&](double cosine) { return radius * std::sqrt(std::max(0.0, 1 - cosine * cosine)); };
    const Vec3 extent{reach(normal.x), reach(normal.y), reach(normal.z)};
    return {centre - extent, centre + extent};
}

} // namespace yarte::trace
