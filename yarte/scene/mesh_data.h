// MeshData: the content of a mesh file, before scale, rotation and translation.
#pragma once

#include "yarte/base/vec3.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace yarte {

/// Polygonal faces over shared vertices; outward normal by the right-hand rule. With `normals` every face is
/// a triangle.
struct MeshData {
    std::string path; ///< as written in the scene: relative to it
    std::vector<Vec3> vertices;
    std::vector<std::uint32_t> faceStarts{0}; ///< faceCount + 1 entries into `corners`
    std::vector<std::uint32_t> corners;       ///< vertex indices, face after face
    std::vector<Vec3> normals;                ///< empty: flat faces. As written, not normalised
    std::vector<std::uint32_t> cornerNormals; ///< as `corners`, into `normals`; empty if `normals` is

    std::size_t faceCount() const { return faceStarts.size() - 1; }
    bool isSmooth() const { return !cornerNormals.empty(); }
    std::span<const std::uint32_t> face(std::size_t f) const {
        return std::span(corners).subspan(faceStarts[f], faceStarts[f + 1] - faceStarts[f]);
    }
    std::span<const std::uint32_t> faceNormals(std::size_t f) const {
        return std::span(cornerNormals).subspan(faceStarts[f], faceStarts[f + 1] - faceStarts[f]);
    }

    friend bool operator==(const MeshData&, const MeshData&) = default;
};

} // namespace yarte
