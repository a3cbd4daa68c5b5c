// The bodies of a glTF scene: a mesh in each place where a node shows it, or what extras say it exactly is.
#pragma once

#include "convert/gltf/exact.h"
#include "convert/gltf/extent.h"
#include "convert/gltf/read_material.h"

namespace yarte::convert::gltf {

struct ReadBodies {
    std::vector<Body> bodies;     ///< `material`: index into Materials::all()
    std::vector<MeshData> meshes; ///< `known` first
    Extent extent;                ///< of all that is shown
};

/// `known`: the meshes that the scene's extras tell of. Nothing after reporting why.
std::optional<ReadBodies> readBodies(Asset&, Materials&, const std::vector<ExactMesh>& known, Ledger&);

} // namespace yarte::convert::gltf
