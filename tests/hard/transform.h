// The same scene elsewhere: larger, moved, turned, or with every coordinate a little off.
#pragma once

#include "tests/support/scenes.h"
#include "yarte/scene/scene.h"

namespace yarte::hard {

/// Every length times s.
Scene scaled(Scene, double s);
Scene moved(Scene, Vec3 by);
/// `turn` must be a rotation that permutes the axes, with signs.
Scene turned(Scene, Vec3 (*turn)(Vec3));
/// Every coordinate of every point (and the distance of every plane) off by `by`, one way or the other.
Scene nudged(Scene, double by, test::Random&);

/// The largest and the smallest length there is, but 0.
struct Extent {
    double largest = 0, smallest = 1;
};
Extent extentOf(Scene);

} // namespace yarte::hard
