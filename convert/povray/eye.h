// Whether the camera starts inside a body: YARTE's answer and POV-Ray's differ for open bodies and unions.
#pragma once

#include "convert/closed_mesh.h"
#include "yarte/scene/scene.h"

namespace yarte::convert::povray {

/// True if POV-Ray would take a camera at `eye` to start inside this disc, truncated cone or open
/// cylinder: a disc's inside is the half-space behind it, an open cone's or cylinder's that of a closed one.
/// In YARTE an open body has no inside.
bool wouldHoldEye(const Body&, Vec3 eye);

/// True if the mesh is closed and `eye` is inside. `placed`: its vertices in the world.
bool isInside(const MeshData&, const std::vector<Vec3>& placed, Vec3 eye);

} // namespace yarte::convert::povray
