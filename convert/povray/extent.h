// How large a scene is, and the scale at which POV-Ray's absolute tolerances do no harm.
#pragma once

#include "yarte/scene/scene.h"

namespace yarte::convert::povray {

/// The longest side of a box around the camera, the lights and the bodies (or around balls that hold them).
double extentOf(const Scene&);

/// The power of two that brings `extent` to [1e5, 2e5). POV-Ray ignores hits nearer than 1e-3 (shadows) or
/// 1e-4 and beyond 1e7. Glass within glass still shows wrong pixels at 1e4; extents from 1e3 to 1e6 do for
/// simpler scenes. 1 where the extent is 0 or not finite.
double worldScaleFor(double extent);

} // namespace yarte::convert::povray
