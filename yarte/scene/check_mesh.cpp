#include "yarte/scene/check.h"

#include "yarte/scene/planarity.h"

#include <fmt/format.h>

#include <algorithm>

namespace yarte {
namespace {

/// More would tell nothing new about a file that a program made wrongly.
constexpr std::size_t maxProblems = 10;

bool allBelow(std::span<const std::uint32_t> indices, std::size_t count) {
    return std::all_of(indices.begin(), indices.end(), [=](std::uint32_t i) { return i < count; });
}

/// The rules of one face. `vertices` is lent as room for its vertices.
void checkFace(const MeshData& mesh, std::size_t f, std::vector<Vec3>& vertices, Problems& problems) {
    const auto face = mesh.face(f);
    const auto broken = [&](std::string_view code, std::string message) {
        problems.push_back({code, std::move(message), static_cast<int>(f)});
    };
    if (face.size() < 3)
        return broken("scene.too-few-vertices",
                      fmt::format("a face must have at least 3 vertices, got {}", face.size()));
    if (mesh.isSmooth() && face.size() != 3)
        return broken(
            "scene.face-not-triangle",
            fmt::format("a face of a mesh with normals must be a triangle, got {} vertices", face.size()));
    if (!allBelow(face, mesh.vertices.size()) ||
        (mesh.isSmooth() && !allBelow(mesh.faceNormals(f), mesh.normals.size())))
        return broken("scene.index-out-of-range",
                      "a face's indices must be below the number of what they name");
    if (face.size() == 3) return;
    vertices.clear();
    for (const std::uint32_t corner : face) vertices.push_back(mesh.vertices[corner]);
    // A face without area occurs in real meshes: no ray meets it.
    if (const auto flat = planarity(vertices); flat && flat->error > maxPlanarityError)
        broken("scene.face-not-planar", fmt::format("a face must be planar within {} of its size, got {:.4g}",
                                                    maxPlanarityError, flat->error));
}

} // namespace

Problems check(const MeshData& mesh) {
    if (mesh.faceCount() == 0) return {{"scene.mesh-empty", "a mesh must have at least one face, got none"}};
    if (!std::all_of(mesh.vertices.begin(), mesh.vertices.end(), isFinite) ||
        !std::all_of(mesh.normals.begin(), mesh.normals.end(), isFinite))
        return {{"scene.not-finite", "the vertices and normals of a mesh must be finite"}};
    Problems problems;
    std::vector<Vec3> vertices;
    for (std::size_t f = 0; f < mesh.faceCount() && problems.size() < maxProblems; ++f)
        checkFace(mesh, f, vertices, problems);
    return problems;
}

} // namespace yarte
