// Hierarchy: where the nodes of the scene stand in the world.
#pragma once

#include "convert/gltf/content.h"

namespace yarte::convert::gltf {

/// A node of the scene, once for each of its instances (EXT_mesh_gpu_instancing).
struct PlacedNode {
    std::uint32_t node = 0;
    Transform world;
};

class Hierarchy {
public:
    explicit Hierarchy(const Document&);

    /// Of any node, in the scene or not: joints may be elsewhere.
    const Transform& world(std::uint32_t node) const { return worlds_[node]; }
    /// The nodes of the scene, parents first.
    const std::vector<std::uint32_t>& inScene() const { return inScene_; }
    /// Those of them that are not hidden, by themselves or an ancestor.
    const std::vector<std::uint32_t>& shown() const { return shown_; }

private:
    std::vector<Transform> worlds_;
    std::vector<std::uint32_t> inScene_, shown_;
};

/// The world transforms of the node's instances, one if it has no instancing; nothing after reporting why.
std::optional<std::vector<Transform>> instancesOf(std::uint32_t node, const Hierarchy&, Content&);

/// From the bind pose to the world, for each joint; nothing after reporting why.
std::optional<std::vector<Transform>> jointsOf(const Skin&, const Hierarchy&, Content&);

} // namespace yarte::convert::gltf
