// A scene around a lone mesh: what a mesh file does not say, made up so that it can be rendered.
#pragma once

#include "convert/ledger.h"
#include "yarte/scene/scene.h"

namespace yarte::convert {

/// One body with a grey material, a camera that sees all of it, and a light; each of the three is in the
/// ledger as added.
Scene sceneAround(MeshData, Ledger&);

} // namespace yarte::convert
