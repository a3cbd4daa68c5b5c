// Curved shapes as meshes: the same scene for who wants triangles, or to see what they cost.
#pragma once

#include "convert/ledger.h"
#include "yarte/scene/scene.h"

#include <optional>

namespace yarte::convert {

/// `scene` with a mesh in the place of each sphere, cone, cylinder, frustum and disc, no farther than
/// `chordError` from it; none: a thousandth of the radius. Shapes of the same measures share a mesh.
Scene withMeshesForCurvedShapes(Scene scene, std::optional<double> chordError, Ledger&);

} // namespace yarte::convert
