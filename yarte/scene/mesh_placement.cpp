#include "yarte/scene/mesh_placement.h"

#include "yarte/scene/referential.h"

namespace yarte {

std::vector<Vec3> placedVertices(const MeshData& data, const Mesh& mesh) {
    const Frame axes = resolveReferential(mesh.axes);
    std::vector<Vec3> placed;
    placed.reserve(data.vertices.size());
    for (const Vec3 v : data.vertices) placed.push_back(axes.toWorld(mesh.scale * v) + mesh.translation);
    return placed;
}

} // namespace yarte
