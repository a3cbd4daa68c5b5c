// GeometryPrint: recognises a mesh again after tools have reordered, reindexed or repacked it.
#pragma once

#include <array>
#include <cstdint>
#include <string>

namespace yarte::convert::gltf {

/// The set of a primitive's triangles by their positions, to the last bit of float32, in the mesh's own
/// coordinates. The order of triangles, which corner comes first, indices, shared or repeated vertices, -0
/// for 0 and triangles with two equal corners do not matter; orientation does. Normals and other attributes
/// are left out: tools recompute them.
class GeometryPrint {
public:
    using Corner = std::array<float, 3>;

    void add(const Corner& a, const Corner& b, const Corner& c);

    /// "12-9f86d081884c7d65": triangles and hash.
    std::string text() const;
    /// The largest magnitude of a coordinate.
    double reach() const { return reach_; }

private:
    std::uint64_t count_ = 0, sum_ = 0;
    double reach_ = 0;
};

} // namespace yarte::convert::gltf
