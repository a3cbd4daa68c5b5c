// The geometry of a glTF file as one mesh, for the `mesh` directive of a scene.
#pragma once

#include "yarte/base/diagnostic.h"
#include "yarte/base/file.h"
#include "yarte/base/source.h"
#include "yarte/scene/mesh_data.h"

#include <filesystem>
#include <optional>

namespace yarte::convert::gltf {

/// All triangles of the default scene (otherwise the first), in world coordinates; materials, lights and
/// cameras are left out. Smooth if every primitive has normals. Nothing after reporting why. Fits
/// MeshFormat::read.
std::optional<MeshData> readMesh(const std::filesystem::path& file, const ReadableFolders&, Sources&,
                                 Diagnostics&);

} // namespace yarte::convert::gltf
