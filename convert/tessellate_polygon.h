// Polygons and polygonal meshes as triangles.
#pragma once

#include "convert/tessellate.h"
#include "yarte/scene/mesh_data.h"

#include <span>

namespace yarte::convert {

struct Triangulation {
    /// Indices into the outline, and behind it into `added`; their front is that of Newell's normal.
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<Vec3> added; ///< points on edges of the outline
};

/// The inside, even-odd, of a closed quasi-planar outline. A simple outline is cut at its own vertices alone;
/// one that touches or crosses itself into trapezoids, which end at points on its edges.
Triangulation triangulate(std::span<const Vec3> outline);

/// `centre` becomes the origin.
Tessellation tessellatePolygon(std::span<const Vec3> outline, Vec3 centre);

/// In the mesh's own coordinates. The positions are the mesh's vertices in their order, unless its vertices
/// and normals have indices of their own.
Tessellation tessellateMesh(const MeshData&);

/// True if `data`, but for its path, can be told from the tessellation alone, to the last bit.
bool isSaidBy(const Tessellation&, const MeshData& data);

} // namespace yarte::convert
