// POV-Ray's lights as point lights without fall-off.
#pragma once

#include "convert/povray/sdl/model.h"
#include "convert/povray/sdl/report.h"

namespace yarte::convert::povray::sdl {

/// `world`: from the light's own coordinates to the scene's.
Light buildLight(const LightShape&, const Affine& world, Span, Report&);

} // namespace yarte::convert::povray::sdl
