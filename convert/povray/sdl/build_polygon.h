// POV-Ray's polygons: even-odd fill of one or more contours, as in YARTE.
#pragma once

#include "convert/povray/sdl/build_round.h"

namespace yarte::convert::povray::sdl {

Built build(const PolygonShape&, const Affine&);

} // namespace yarte::convert::povray::sdl
