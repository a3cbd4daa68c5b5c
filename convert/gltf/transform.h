// Transform: an affine map, as a node's place in the world. Columns; points are column vectors (glTF 2.0
// section 3.5).
#pragma once

#include "yarte/base/vec3.h"
#include "yarte/scene/shapes.h"

#include <array>
#include <optional>

namespace yarte::convert::gltf {

struct Transform {
    Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1}, translation;

    friend constexpr bool operator==(const Transform&, const Transform&) = default;

    constexpr Vec3 direction(Vec3 v) const { return x * v.x + y * v.y + z * v.z; }
    constexpr Vec3 point(Vec3 v) const { return direction(v) + translation; }
    constexpr double determinant() const { return dot(cross(x, y), z); }
};

/// First `inner`, then `outer`.
constexpr Transform operator*(const Transform& outer, const Transform& inner) {
    return {outer.direction(inner.x), outer.direction(inner.y), outer.direction(inner.z),
            outer.point(inner.translation)};
}

/// Translation * rotation * scale. `rotation` is a quaternion x y z w, not 0; its length does not matter.
Transform fromParts(Vec3 translation, std::array<double, 4> rotation, Vec3 scale);

/// How normals are mapped: the inverse transpose, times the determinant's magnitude, so that it exists for
/// every transform.
Transform normalTransform(const Transform&);

/// A rotation with a uniform positive scale and a translation.
struct Similarity {
    double scale = 1;
    Referential axes; ///< with z
    Vec3 translation;
};

/// Axes or scales that differ by more than this, relative, are no similarity: what float32 rounding of a
/// quaternion or a matrix leaves is below.
inline constexpr double similarityTolerance = 1e-6;

std::optional<Similarity> asSimilarity(const Transform&);

} // namespace yarte::convert::gltf
