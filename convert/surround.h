// Surround: where a scene is, and how large.
#pragma once

#include "yarte/scene/scene.h"

#include <limits>

namespace yarte::convert {

/// Axis-parallel box; empty at first.
struct Surround {
    static constexpr double infinity = std::numeric_limits<double>::infinity();
    Vec3 low{infinity, infinity, infinity}, high{-infinity, -infinity, -infinity};

    void addPoint(Vec3 p) { addBall(p, 0); }
    void addBall(Vec3 centre, double radius);
    Vec3 centre() const { return low + (high - low) / 2; }
    double longestSide() const;
};

/// Around the camera, the lights and the bodies, or balls that hold them; of a plane, the point below the
/// camera. Lights that are very far away do not count.
Surround surroundOf(const Scene&);

/// The point of the plane that is nearest to `p`.
Vec3 footOn(const Plane&, Vec3 p);

} // namespace yarte::convert
