#include "yarte/scene/mesh_placement.h"

#include "yarte/scene/referential.h"

namespace yarte {

MeshPlacement::MeshPlacement(const Mesh& mesh)
    : scale_(mesh.scale), axes_(resolveReferential(mesh.axes)), translation_(mesh.translation) {}

std::vector<Vec3> placedVertices(const MeshData& data, const Mesh& mesh) {
    const MeshPlacement place(mesh);
    std::vector<Vec3> placed;
    placed.reserve(data.vertices.size());
    for (const Vec3 v : data.vertices) placed.push_back(place(v));
    return placed;
}

} // namespace yarte
