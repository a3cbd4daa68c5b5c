// Lengths of a file as multiples of its unit, a power of two: no digit changes.
#pragma once

#include "yarte/scene/scene.h"

namespace yarte::convert::povray::sdl {

Shape inUnits(Shape, double unit);

} // namespace yarte::convert::povray::sdl
