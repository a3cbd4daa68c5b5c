// Canonical text of a scene: printing, reading and printing again gives the same bytes, and the same Scene to
// the last bit.
#pragma once

#include "yarte/scene/scene.h"

#include <string>

namespace yarte {

/// Settings first, then lights, then bodies, each under its material; numbers as printNumber. Mesh files are
/// named by MeshData::path.
std::string printScene(const Scene&);

} // namespace yarte
