#include "convert/pmf_format.h"

#include "convert/framing.h"
#include "yarte/lang/pmf.h"
#include "yarte/scene/mesh_placement.h"
#include "yarte/scene/referential.h"

#include <fmt/format.h>

#include <numeric>
#include <utility>

namespace yarte::convert {
namespace {

/// Appends faces over `vertices`; their corners count from the first of these.
void addFaces(MeshData& all, const std::vector<Vec3>& vertices, std::span<const std::uint32_t> corners,
              std::span<const std::uint32_t> faceStarts) {
    const auto firstVertex = static_cast<std::uint32_t>(all.vertices.size());
    const auto firstCorner = static_cast<std::uint32_t>(all.corners.size());
    all.vertices.insert(all.vertices.end(), vertices.begin(), vertices.end());
    for (const std::uint32_t corner : corners) all.corners.push_back(firstVertex + corner);
    for (const std::uint32_t start : faceStarts.subspan(1)) all.faceStarts.push_back(firstCorner + start);
}

void addMesh(MeshData& all, const MeshData& data, const Mesh& mesh) {
    const Frame axes = resolveReferential(mesh.axes);
    const bool inPlace = axes == Frame{} && mesh.scale == 1 && mesh.translation == Vec3{};
    addFaces(all, inPlace ? data.vertices : placedVertices(data, mesh), data.corners, data.faceStarts);
    const auto firstNormal = static_cast<std::uint32_t>(all.normals.size());
    for (const Vec3 n : data.normals) all.normals.push_back(inPlace ? n : axes.toWorld(n));
    for (const std::uint32_t corner : data.cornerNormals) all.cornerNormals.push_back(firstNormal + corner);
}

void addPolygon(MeshData& all, const Polygon& polygon) {
    std::vector<std::uint32_t> corners(polygon.vertices.size());
    std::iota(corners.begin(), corners.end(), 0U);
    const std::uint32_t starts[] = {0, static_cast<std::uint32_t>(corners.size())};
    addFaces(all, polygon.vertices, corners, starts);
}

void reportDropped(const Scene& scene, const MeshData& all, Ledger& ledger) {
    const auto drop = [&](const char* where, std::string detail) {
        if (!ledger.wasAdded(where))
            ledger.add({where, "everything", Action::dropped, std::move(detail), {}});
    };
    drop("camera", "a mesh file has none");
    if (!scene.lights.empty())
        drop("light 1", fmt::format("a mesh file has no lights ({} here)", scene.lights.size()));
    if (!scene.materials.empty())
        drop("material 1", fmt::format("a mesh file has no materials ({} here)", scene.materials.size()));
    std::size_t meshes = 0, polygons = 0;
    for (const Body& body : scene.bodies) {
        meshes += std::holds_alternative<Mesh>(body.shape);
        polygons += std::holds_alternative<Polygon>(body.shape);
    }
    if (const std::size_t others = scene.bodies.size() - meshes - polygons)
        drop("bodies", fmt::format("{} are neither a mesh nor a polygon", others));
    if (meshes + polygons > 1) drop("bodies' limits", "all faces are one mesh");
    ledger.add({"faces",
                "vertices",
                Action::exact,
                fmt::format("{} faces, in world coordinates", all.faceCount()),
                {}});
}

} // namespace

std::optional<Scene> readMeshAsScene(Conversion& c) {
    std::optional<MeshData> mesh = parsePmf(c.input.text, c.sources, c.diagnostics);
    if (!mesh) return std::nullopt;
    mesh->path = c.input.file.filename().string();
    return sceneAround(std::move(*mesh), c.ledger);
}

std::vector<OutputFile> writeMesh(const Scene& scene, Conversion& c) {
    MeshData all;
    for (const Body& body : scene.bodies) {
        if (const auto* mesh = std::get_if<Mesh>(&body.shape))
            addMesh(all, scene.meshes[mesh->mesh.index], *mesh);
        if (const auto* polygon = std::get_if<Polygon>(&body.shape)) addPolygon(all, *polygon);
    }
    if (all.faceCount() == 0) {
        c.diagnostics.error("convert.no-mesh", "the scene has neither a mesh nor a polygon to write");
        return {};
    }
    reportDropped(scene, all, c.ledger);
    if (all.isSmooth() && all.cornerNormals.size() != all.corners.size()) {
        all.normals.clear(), all.cornerNormals.clear();
        c.ledger.add({"faces", "normals", Action::dropped, "some faces have none", {}});
    }
    return {{c.output, printPmf(all)}};
}

} // namespace yarte::convert
