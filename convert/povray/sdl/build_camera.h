// POV-Ray's cameras as YARTE's, which is right-handed.
#pragma once

#include "convert/povray/sdl/model.h"
#include "convert/povray/sdl/report.h"
#include "yarte/base/diagnostic.h"

namespace yarte::convert::povray::sdl {

/// True if `right` points to the left: the picture is that of the mirrored world.
bool isLeftHanded(const CameraModel&);

/// `world`: from the model's coordinates to the scene's, whose `bodies` are complete. Nothing after telling
/// why not.
std::optional<Camera> buildCamera(const CameraModel&, const Affine& world, const Scene& bodies, Report&,
                                  Diagnostics&);

} // namespace yarte::convert::povray::sdl
