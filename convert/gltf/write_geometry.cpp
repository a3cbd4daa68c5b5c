#include "convert/gltf/write_geometry.h"

#include "convert/tessellate_polygon.h"

#include <algorithm>

namespace yarte::convert::gltf {
const Geometry& Geometries::of(const Body& body, const ShownShape& shape) {
    const auto found = known_.find(shape.key);
    if (found != known_.end()) return found->second;
    return known_.emplace(shape.key, make(body, shape)).first->second;
}

Geometry Geometries::make(const Body& body, const ShownShape& shape) {
    const Tessellation t = tessellate(body, shape, scene_, chordError_);
    Geometry result;
    if (const auto* mesh = std::get_if<yarte::Mesh>(&body.shape))
        result.isSaid = isSaidBy(t, scene_.meshes[mesh->mesh.index]);
    for (const auto& [a, b, c] : t.triangles)
        result.print.add(t.positions[a], t.positions[b], t.positions[c]);
    result.triangles = t.triangles.size();
    result.deviation = t.deviation;
    result.low = result.high = widened(t.positions[0]);
    for (const Vec3f& p : t.positions) {
        const Vec3 v = widened(p);
        result.low = {std::min(result.low.x, v.x), std::min(result.low.y, v.y), std::min(result.low.z, v.z)};
        result.high = {std::max(result.high.x, v.x), std::max(result.high.y, v.y),
                       std::max(result.high.z, v.z)};
    }
    Json attributes = object({{"POSITION", json(output_.addPositions(t.positions))}});
    if (!t.normals.empty()) set(attributes, "NORMAL", json(output_.addNormals(t.normals)));
    result.primitive =
        object({{"attributes", std::move(attributes)}, {"indices", json(output_.addIndices(t.triangles))}});
    if (shape.implicit.isObject()) result.implicit = output_.add(implicitShapes, "shapes", shape.implicit);
    return result;
}

} // namespace yarte::convert::gltf
