#include "convert/gltf/asset.h"

#include "convert/gltf/container.h"

#include <algorithm>
#include <limits>

namespace yarte::convert::gltf {
namespace {

/// Of all meshes and instances, in bytes: what any file may have, and what it may have for each of its own
/// bytes.
constexpr std::size_t anyRoom = std::size_t{1} << 30, roomPerByte = 32;

std::size_t bytesOf(const MeshSize& size) {
    const std::size_t kinds = size.smooth ? 2 : 1;
    return kinds * size.vertices * sizeof(Vec3) +
           (kinds * size.corners + size.corners / 3) * sizeof(std::uint32_t);
}

} // namespace

std::unique_ptr<Asset> Asset::open(std::string_view bytes, const std::string& name, UriBase base,
                                   Diagnostics& diagnostics) {
    const auto container = openContainer(bytes, name, diagnostics);
    if (!container) return nullptr;
    auto root = parseJson(container->json, name, diagnostics);
    if (!root) return nullptr;
    std::unique_ptr<Asset> asset(new Asset(std::move(*root), name, diagnostics));
    asset->document_ = readDocument(asset->root_, asset->errors_);
    if (!asset->document_) return nullptr;
    asset->content_.emplace(*asset->document_, container->binary.value_or(""), bytes.size(), std::move(base),
                            asset->errors_);
    asset->hierarchy_.emplace(*asset->document_);
    asset->room_ = anyRoom + roomPerByte * bytes.size();
    return asset;
}

std::optional<Pose> Asset::poseOf(std::uint32_t id) {
    const Node& node = document_->nodes[id];
    Pose pose{.weights = node.weights.empty() ? document_->meshes[*node.mesh].weights : node.weights,
              .joints = {}};
    if (!node.skin) return pose;
    auto joints = jointsOf(document_->skins[*node.skin], *hierarchy_, *content_);
    if (!joints) return std::nullopt;
    pose.joints = std::move(*joints);
    return pose;
}

bool Asset::takeRoom(std::size_t bytes, const Json& at) {
    if (bytes > room_) {
        errors_.report("gltf.too-large", "meshes and instances are too large for a file of this size", at);
        return false;
    }
    room_ -= bytes;
    return true;
}

bool Asset::takeRoom(const MeshSize& size, const Json& at) {
    const bool fitsIndices =
        std::max(size.vertices, size.corners) <= std::numeric_limits<std::uint32_t>::max();
    return takeRoom(fitsIndices ? bytesOf(size) : std::numeric_limits<std::size_t>::max(), at);
}

} // namespace yarte::convert::gltf
