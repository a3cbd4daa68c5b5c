// Bodies as nodes.
#pragma once

#include "convert/gltf/extent.h"
#include "convert/gltf/write_geometry.h"
#include "convert/gltf/write_material.h"

namespace yarte::convert::gltf {

/// A body with what shows it.
struct ShownBody {
    const Body& body;
    ShownShape shape;
    const Geometry& geometry; ///< lives in Geometries
};

std::vector<ShownBody> shownBodies(const Scene&, Geometries&);

/// Which shapes an engine may collide with: what KHR_implicit_shapes are for.
inline constexpr const char* rigidBodies = "KHR_physics_rigid_bodies";

/// One node for each; the same triangles in the same material are one mesh. The nodes' indices.
std::vector<std::size_t> writeBodies(const std::vector<ShownBody>&, const WrittenMaterials&, Output&);

bool isPlane(const Body&);

/// The box around all bodies but planes, around the middles of these if there is nothing else; nothing
/// without bodies.
std::optional<Extent> extentOf(const std::vector<ShownBody>&);

} // namespace yarte::convert::gltf
