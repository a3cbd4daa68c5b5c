// Where a mesh's vertices lie in the world. One place, so that renderer and converters agree to the last bit.
#pragma once

#include "yarte/base/frame.h"
#include "yarte/scene/mesh_data.h"
#include "yarte/scene/shapes.h"

#include <vector>

namespace yarte {

class MeshPlacement {
public:
    explicit MeshPlacement(const Mesh&);

    const Frame& axes() const { return axes_; }
    /// R(scale * v) + translation.
    Vec3 operator()(Vec3 v) const { return axes_.toWorld(scale_ * v) + translation_; }

private:
    double scale_;
    Frame axes_;
    Vec3 translation_;
};

/// Of every vertex of `data`.
std::vector<Vec3> placedVertices(const MeshData& data, const Mesh& mesh);

} // namespace yarte
