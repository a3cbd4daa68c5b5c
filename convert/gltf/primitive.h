// A mesh primitive as a mesh of triangles.
#pragma once

#include "convert/gltf/content.h"
#include "yarte/scene/mesh_data.h"

namespace yarte::convert::gltf {

/// How a primitive is deformed where it stands.
struct Pose {
    std::vector<double> weights;   ///< of the morph targets; those missing are 0
    std::vector<Transform> joints; ///< from the skin's bind pose to the world; empty: no skin
};

/// The primitive's triangles in the mesh's coordinates, or in the world's if the pose has joints. It must
/// have triangles and positions. Nothing after reporting why. Smooth if it has normals. A vertex normal of
/// length 0, which says nothing, is replaced by those of the triangles around.
std::optional<MeshData> readPrimitive(Content&, const Primitive&, const Pose&);

/// Moves `mesh`; a reflection also turns its faces, so that the outside stays outside.
void transform(MeshData& mesh, const Transform&);

} // namespace yarte::convert::gltf
