// Where a mesh's vertices lie in the world. One function, so that renderer and converters agree to the last bit.
#pragma once

#include "yarte/scene/mesh_data.h"
#include "yarte/scene/shapes.h"

#include <vector>

namespace yarte {

/// R(scale * v) + translation for every vertex v of `data`.
std::vector<Vec3> placedVertices(const MeshData& data, const Mesh& mesh);

} // namespace yarte
