// POV-Ray's lights as point lights without fall-off.
#pragma once

#include "convert/povray/sdl/model.h"
#include "convert/povray/sdl/report.h"

#include <optional>

namespace yarte::convert::povray::sdl {

struct BuiltLight {
    Light light;
    std::optional<Vec3> rays; ///< parallel ones: the unit vector along them
};

/// `world`: from the light's own coordinates to the scene's. None: it lights nothing, which is told.
std::optional<BuiltLight> buildLight(const LightShape&, const Affine& world, Span, Report&);

/// Parallel rays come from a point far away from all bodies.
Light placed(const BuiltLight&, const Scene& bodies, Report&);

} // namespace yarte::convert::povray::sdl
