#include "convert/gltf/mesh_reader.h"

#include "convert/gltf/asset.h"
#include "yarte/base/huge_pages.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <utility>

namespace yarte::convert::gltf {
namespace {

/// A primitive wherever it stands.
struct Piece {
    const Primitive* primitive = nullptr;
    std::uint32_t node = 0;
    std::shared_ptr<const std::vector<Transform>> places; ///< the same for all of its mesh
};

/// Nothing after reporting an error.
std::optional<std::vector<Piece>> piecesOf(Asset& asset) {
    std::vector<Piece> pieces;
    for (const std::uint32_t id : asset.hierarchy().shown()) {
        const Node& node = asset.document().nodes[id];
        if (!node.mesh) continue;
        auto instances = instancesOf(id, asset.hierarchy(), asset.content());
        if (!instances || !asset.takeRoom(instances->size() * sizeof(Transform), *node.json))
            return std::nullopt;
        const auto places = std::make_shared<const std::vector<Transform>>(std::move(*instances));
        for (const Primitive& primitive : asset.document().meshes[*node.mesh].primitives)
            if (primitive.hasTriangles() && primitive.position) pieces.push_back({&primitive, id, places});
    }
    return pieces;
}

/// Each part of `mesh` is released once it is in `all`, so that a large mesh is never there twice.
void append(MeshData& all, MeshData mesh, bool smooth) {
    const auto moveIndices = [](std::vector<std::uint32_t>& to, std::vector<std::uint32_t> from,
                                std::size_t first) {
        for (const std::uint32_t i : from) to.push_back(i + static_cast<std::uint32_t>(first));
    };
    const auto moveVectors = [](std::vector<Vec3>& to, std::vector<Vec3> from) {
        to.insert(to.end(), from.begin(), from.end());
    };
    for (std::size_t f = 0; f < mesh.faceCount(); ++f) all.faceStarts.push_back(all.faceStarts.back() + 3);
    moveIndices(all.corners, std::move(mesh.corners), all.vertices.size());
    moveVectors(all.vertices, std::move(mesh.vertices));
    if (!smooth) return;
    moveIndices(all.cornerNormals, std::move(mesh.cornerNormals), all.normals.size());
    moveVectors(all.normals, std::move(mesh.normals));
}

/// Room for all pieces in `all`; false after reporting that they need too much.
bool reserve(MeshData& all, const std::vector<Piece>& pieces, Asset& asset, bool smooth) {
    std::size_t vertices = 0, corners = 0;
    for (const Piece& piece : pieces) {
        const Primitive& p = *piece.primitive;
        const std::size_t count = asset.document().accessors[*p.position].count;
        const std::size_t order = p.indices ? asset.document().accessors[*p.indices].count : count;
        vertices += count * piece.places->size();
        corners += (p.mode == Mode::triangles ? order : 3 * order) * piece.places->size();
    }
    if (!asset.takeRoom({.vertices = vertices, .corners = corners, .smooth = smooth}, asset.root()))
        return false;
    if (pieces.size() == 1 && pieces[0].places->size() == 1) return true; // taken as it is
    reserveWhole(all.vertices, vertices), reserveWhole(all.corners, corners);
    reserveWhole(all.faceStarts, corners / 3 + 1);
    if (smooth) reserveWhole(all.normals, vertices), reserveWhole(all.cornerNormals, corners);
    return true;
}

std::optional<MeshData> collect(Asset& asset) {
    const auto pieces = piecesOf(asset);
    if (!pieces) return std::nullopt;
    const bool smooth =
        std::ranges::all_of(*pieces, [](const Piece& piece) { return piece.primitive->normal.has_value(); });
    MeshData all;
    if (!reserve(all, *pieces, asset, smooth)) return std::nullopt;
    for (const Piece& piece : *pieces) {
        const auto pose = asset.poseOf(piece.node);
        if (!pose) return std::nullopt;
        auto mesh = readPrimitive(asset.content(), *piece.primitive, *pose);
        if (!mesh) return std::nullopt;
        const bool isPosed = !pose->joints.empty() && !piece.primitive->joints.empty();
        for (const Transform& place : *piece.places) {
            const bool isOnly = pieces->size() == 1 && piece.places->size() == 1;
            MeshData placed = &place == &piece.places->back() ? std::move(*mesh) : *mesh;
            if (!isPosed) transform(placed, place);
            if (isOnly) return placed;
            append(all, std::move(placed), smooth);
        }
    }
    return all;
}

} // namespace

std::optional<MeshData> readMesh(const std::filesystem::path& file, const ReadableFolders& readable, Sources&,
                                 Diagnostics& diagnostics) {
    try {
        const std::string bytes = readFile(file);
        const auto asset = Asset::open(bytes, file.string(), uriBase(file, readable), diagnostics);
        if (!asset) return std::nullopt;
        std::optional<MeshData> mesh = collect(*asset);
        if (!mesh || asset->errors().any()) return std::nullopt;
        if (mesh->faceCount() > 0) return mesh;
        asset->errors().report("gltf.no-triangles", "the scene has no triangles", asset->root());
    } catch (const FileError& error) {
        diagnostics.error("gltf.unreadable", fmt::format("cannot read the file: {}", error.reason())).file =
            file.string();
    }
    return std::nullopt;
}

} // namespace yarte::convert::gltf
