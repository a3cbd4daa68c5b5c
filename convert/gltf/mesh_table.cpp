#include "convert/gltf/mesh_table.h"

#include "yarte/scene/check.h"

#include <algorithm>

namespace yarte::convert::gltf {
namespace {

MeshSize sizeOf(const MeshData& mesh) { return {mesh.vertices.size(), mesh.corners.size(), mesh.isSmooth()}; }

} // namespace

/// Skinned meshes are never the same: their key has the node.
MeshTable::Key MeshTable::keyOf(const Placing& p) {
    return {p.mesh, p.index, p.pose->weights, p.isPosed() ? p.nodeJson : nullptr};
}

std::optional<MeshData> MeshTable::read(const Placing& placing) {
    auto mesh = readPrimitive(asset_.content(), *placing.primitive, *placing.pose);
    if (!mesh || !asset_.takeRoom(sizeOf(*mesh), *placing.nodeJson)) return std::nullopt;
    const auto [extent, isNew] = extents_.try_emplace(keyOf(placing));
    if (isNew)
        for (const Vec3 v : mesh->vertices) extent->second.add(v);
    return mesh;
}

std::optional<yarte::Mesh> MeshTable::place(const Placing& placing) {
    const auto similarity = asSimilarity(placing.isPosed() ? Transform() : placing.world);
    const auto placed = [&](MeshId id) {
        yarte::Mesh mesh{id, 1, {{1, 0, 0}, {0, 1, 0}, Vec3{0, 0, 1}}, {}};
        if (similarity)
            mesh.scale = similarity->scale, mesh.axes = similarity->axes,
            mesh.translation = similarity->translation;
        return mesh;
    };
    if (similarity)
        if (const auto known = shared_.find(keyOf(placing)); known != shared_.end())
            return placed(known->second);
    auto mesh = read(placing);
    if (!mesh || mesh->faceCount() == 0) return std::nullopt;
    if (!similarity) transform(*mesh, placing.world);
    for (const Problem& problem : check(*mesh)) {
        asset_.errors().report(problem.code, problem.message, *placing.nodeJson);
        return std::nullopt;
    }
    const MeshId id{static_cast<std::uint32_t>(taken_.size() + meshes_.size())};
    if (similarity) shared_.emplace(keyOf(placing), id);
    meshes_.push_back(std::move(*mesh));
    return placed(id);
}

bool MeshTable::takeKnown(const Placing& placing, MeshId id) {
    if (id.index >= taken_.size()) return false;
    std::optional<MeshData>& taken = taken_[id.index];
    if (taken) return true;
    taken = known_[id.index].data;
    if (!taken) taken = read(placing);
    if (taken) taken->path = known_[id.index].path;
    return taken.has_value();
}

const Extent& MeshTable::extentOf(const Placing& placing) {
    const auto known = extents_.find(keyOf(placing));
    if (known != extents_.end()) return known->second;
    read(placing);
    return extents_[keyOf(placing)];
}

std::vector<MeshData> MeshTable::finish(std::vector<Body>& bodies) {
    std::vector<MeshData> all;
    std::vector<std::uint32_t> newIndex;
    for (std::size_t i = 0; i < taken_.size(); ++i) {
        // A mesh that no body uses any more is still the scene's.
        if (!taken_[i] && known_[i].data) taken_[i] = known_[i].data;
        newIndex.push_back(static_cast<std::uint32_t>(all.size()));
        if (taken_[i]) all.push_back(std::move(*taken_[i]));
    }
    for (MeshData& mesh : meshes_) {
        newIndex.push_back(static_cast<std::uint32_t>(all.size()));
        all.push_back(std::move(mesh));
    }
    for (Body& body : bodies)
        if (auto* mesh = std::get_if<yarte::Mesh>(&body.shape)) mesh->mesh.index = newIndex[mesh->mesh.index];
    return all;
}

} // namespace yarte::convert::gltf
