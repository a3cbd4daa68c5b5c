// How far the bodies of a scene reach.
#pragma once

#include "yarte/scene/scene.h"

namespace yarte::convert::povray::sdl {

/// Distances along a unit vector from a point, and from it in any direction.
struct Reach {
    double nearest = 0, farthest = 0; ///< along the direction
    double distance = 0;              ///< of the farthest
    bool hasPlane = false;            ///< which has no extent: not counted
    bool isEmpty = true;
};

/// Conservative: bodies count as balls around them.
Reach reachOf(const Scene&, Vec3 from, Vec3 direction);

} // namespace yarte::convert::povray::sdl
