// .pmf: a polygonal mesh, read as a scene of that mesh alone, and written from a scene's meshes and polygons.
#pragma once

#include "convert/format.h"

namespace yarte::convert {

std::optional<Scene> readMeshAsScene(Conversion&);

/// All meshes and polygons of the scene as one mesh, in their places; everything else is dropped. A mesh
/// alone in the scene and in its own place is written as it is. Vertex normals are kept if every face has
/// them.
std::vector<OutputFile> writeMesh(const Scene&, Conversion&);

} // namespace yarte::convert
