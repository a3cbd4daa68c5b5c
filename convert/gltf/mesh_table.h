// MeshTable: the meshes of the scene being made, one for all places that a rotation, uniform scale and
// translation tell apart.
#pragma once

#include "convert/gltf/asset.h"
#include "convert/gltf/exact.h"
#include "convert/gltf/extent.h"

#include <tuple>

namespace yarte::convert::gltf {

/// A primitive in one of its places.
struct Placing {
    std::uint32_t mesh = 0, index = 0; ///< the document's mesh, the primitive in it
    const Primitive* primitive = nullptr;
    const Pose* pose = nullptr;
    Transform world;
    const Json* nodeJson = nullptr;

    /// Its vertices are in the world already.
    bool isPosed() const { return !pose->joints.empty() && !primitive->joints.empty(); }
};

class MeshTable {
public:
    MeshTable(Asset& asset, const std::vector<ExactMesh>& known)
        : asset_(asset), known_(known), taken_(known.size()) {}

    /// The mesh and where it stands. Nothing if it has no triangles, or after reporting an error.
    std::optional<yarte::Mesh> place(const Placing&);

    /// The known mesh `id` becomes a mesh of the scene, from the primitive if that says it all; false if
    /// there is no such mesh.
    bool takeKnown(const Placing&, MeshId id);

    /// In the mesh's own coordinates, or the world's if it is posed.
    const Extent& extentOf(const Placing&);

    /// All meshes, the known ones first; the bodies' ids are made to fit.
    std::vector<MeshData> finish(std::vector<Body>&);

private:
    using Key = std::tuple<std::uint32_t, std::uint32_t, std::vector<double>, const Json*>;
    static Key keyOf(const Placing&);
    std::optional<MeshData> read(const Placing&);

    Asset& asset_;
    const std::vector<ExactMesh>& known_;
    std::vector<std::optional<MeshData>> taken_; ///< of known meshes that a body uses
    std::vector<MeshData> meshes_;               ///< all others
    std::map<Key, MeshId> shared_;
    std::map<Key, Extent> extents_;
};

} // namespace yarte::convert::gltf
