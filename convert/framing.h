// What a file does not say, made up so that it can be rendered: a camera that sees all, a light.
#pragma once

#include "convert/ledger.h"
#include "yarte/scene/scene.h"

namespace yarte::convert {

/// Where the visible is, and how large.
struct Ball {
    Vec3 centre;
    double radius = 1;
};

/// Sees the whole ball; in the ledger as added.
void addCamera(Scene&, const Ball&, Ledger&);
/// White, above the camera that sees the ball; in the ledger as added.
void addLight(Scene&, const Ball&, Ledger&);

/// One body with a grey material, a camera that sees all of it, and a light; each of the three is in the
/// ledger as added.
Scene sceneAround(MeshData, Ledger&);

} // namespace yarte::convert
