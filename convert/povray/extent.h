// How large a scene is, and the scale at which POV-Ray's absolute tolerances do no harm.
#pragma once

#include "yarte/scene/scene.h"

namespace yarte::convert::povray {

/// The longest side of a box around the camera, the lights and the bodies (or around balls that hold them).
double extentOf(const Scene&);

/// The power of two that brings `extent` to [least, 2 least), least being 1e5 if not said. POV-Ray ignores
/// hits nearer than 1e-3 (shadows) or 1e-4 and beyond 1e7. Glass within glass still shows wrong pixels at
/// 1e4; extents from 1e3 to 1e6 do for simpler scenes. 1 where the extent is 0 or not finite.
double worldScaleFor(double extent, double least = 1e5);

/// The scene's. POV-Ray's planes end at 1e7, and so do their horizons, directly seen or in mirrors: with
/// planes the extent is brought to [250, 500) only, where measurements found the fewest wrong pixels of both
/// kinds.
double worldScaleOf(const Scene&);

} // namespace yarte::convert::povray
