// The shapes of the scene language, as a person writes them. `Shape` is the only list of the kinds:
// visiting it without a catch-all makes a new kind fail to compile until every part of YARTE knows it.
// Lengths in scene units. See yarte/LANGUAGE.md; validity rules are in scene/check.h.
#pragma once

#include "yarte/base/vec3.h"

#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

namespace yarte {

/// Axes as written: versors, not yet normalised; see resolveReferential in scene/referential.h. No z: x cross
/// y.
struct Referential {
    Vec3 x{1, 0, 0}, y{0, 1, 0};
    std::optional<Vec3> z;
    friend bool operator==(const Referential&, const Referential&) = default;
};

struct Sphere {
    Vec3 centre;
    double radius = 1;
    friend bool operator==(const Sphere&, const Sphere&) = default;
};

/// Axis-parallel in its local axes; `sides` are full lengths.
struct Box {
    Vec3 centre, sides{1, 1, 1};
    friend bool operator==(const Box&, const Box&) = default;
};

/// Closed by its base disc; axis +y.
struct Cone {
    Vec3 centre; ///< of the base
    double radius = 1, height = 1;
    friend bool operator==(const Cone&, const Cone&) = default;
};

/// Open at both ends; axis +y.
struct TruncatedCone {
    Vec3 centre;           ///< of the base
    double radius = 1;     ///< of the base
    double coneHeight = 1; ///< of the full cone
    double height = 1;     ///< kept, at most coneHeight
    friend bool operator==(const TruncatedCone&, const TruncatedCone&) = default;
};

/// Normal +y.
struct Disc {
    Vec3 centre;
    double radius = 1;
    friend bool operator==(const Disc&, const Disc&) = default;
};

/// Quasi-planar, may be concave, filled even-odd; normal by Newell's rule. Has no referential.
struct Polygon {
    std::vector<Vec3> vertices;
    friend bool operator==(const Polygon&, const Polygon&) = default;
};

/// Index into Scene::meshes.
struct MeshId {
    std::uint32_t index = 0;
    friend constexpr bool operator==(MeshId, MeshId) = default;
};

/// A vertex v of the file becomes R(scale * v) + translation.
struct Mesh {
    MeshId mesh;
    double scale = 1;
    Referential axes; ///< of R; always with z as written, {0, 0, 0} included
    Vec3 translation;
    friend bool operator==(const Mesh&, const Mesh&) = default;
};

/// Closed by its two discs; axis +y.
struct Cylinder {
    Vec3 centre; ///< of the base
    double radius = 1, height = 1;
    friend bool operator==(const Cylinder&, const Cylinder&) = default;
};

/// Open at both ends; axis +y.
struct OpenCylinder {
    Vec3 centre; ///< of the base
    double radius = 1, height = 1;
    friend bool operator==(const OpenCylinder&, const OpenCylinder&) = default;
};

/// A cone without its tip, closed by its two discs, either of which may be the larger; axis +y.
struct Frustum {
    Vec3 centre; ///< of the base
    double baseRadius = 1, topRadius = 1, height = 1;
    friend bool operator==(const Frustum&, const Frustum&) = default;
};

/// Infinite: all points p with n.p = distance, n being the unit normal; its inside is where n.p < distance.
struct Plane {
    Vec3 normal{0, 1, 0}; ///< as written: of any length but 0; see unitVector
    double distance = 0;  ///< from the origin, along the normal
    friend bool operator==(const Plane&, const Plane&) = default;
};

using Shape = std::variant<Sphere, Box, Cone, TruncatedCone, Disc, Polygon, Mesh, Cylinder, OpenCylinder,
                           Frustum, Plane>;

} // namespace yarte
