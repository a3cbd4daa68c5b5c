// Meshes as arrays of their files' numbers, and bodies made of them.
#pragma once

#include "yarte/scene/scene.h"

#include <string>

namespace yarte::convert::povray {

/// The arrays Mesh_1_Vertices, Mesh_1_Faces and, of a smooth mesh, Mesh_1_Normals and Mesh_1_Face_Normals.
/// `plain`: where all faces are triangles, the object Mesh_1 instead, which POV-Ray reads and renders
/// fastest.
std::string meshDeclarations(const Scene&, bool plain);

/// A mesh body as an SDL object, up to its material.
std::string meshObject(const Scene&, const Body&, const Mesh&, bool plain);

/// True if POV-Ray will round this mesh's vertices to float32.
bool isRounded(const MeshData&, bool plain);

} // namespace yarte::convert::povray
