// Shapes that YARTE wrote itself and that come back as they were, or moved if somebody moved them.
#pragma once

#include "convert/povray/sdl/model.h"

namespace yarte::convert::povray::sdl {

struct ExactBody {
    Shape shape;
    std::optional<Referential> referential;
};

/// `shape` is in the scene's units, of which `unit` of the file's are one; `axes`: as Object::exactAxes.
/// Nothing if the map leaves it no shape of YARTE's. Meshes must be in right-handed maps: see
/// convert/README.md.
std::optional<ExactBody> place(const Shape&, const Affine&, const std::optional<Referential>& axes,
                               double unit);

} // namespace yarte::convert::povray::sdl
