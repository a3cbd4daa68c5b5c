// Whether a mesh has an inside.
#pragma once

#include "yarte/scene/mesh_data.h"

namespace yarte::convert {

/// True if every edge is met once in each direction.
bool isClosed(const MeshData&);

} // namespace yarte::convert
