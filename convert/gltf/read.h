// Reads glTF 2.0 scenes. How everything in them becomes YARTE's is in convert/README.md.
#pragma once

#include "convert/format.h"

namespace yarte::convert::gltf {

/// .gltf or .glb, told apart by content; the scene, or nothing after reporting why.
std::optional<Scene> readScene(Conversion&);

} // namespace yarte::convert::gltf
