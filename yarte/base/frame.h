// Frame: a right-handed orthonormal set of axes (the paper's "referential").
#pragma once

#include "yarte/base/twofold.h"
#include "yarte/base/vec3.h"

namespace yarte {

struct Frame {
    Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};

    friend constexpr bool operator==(const Frame&, const Frame&) = default;

    /// Components of the world vector `v` along the axes (the paper's SchimbTriedru).
    constexpr Vec3 toLocal(Vec3 v) const { return {dot(v, x), dot(v, y), dot(v, z)}; }
    /// The world vector with components `v` along the axes (the paper's SchimbTriedruInvers).
    constexpr Vec3 toWorld(Vec3 v) const { return x * v.x + y * v.y + z * v.z; }
};

/// The rotation closest (least squares) to the axes x, y, z, by Newton's iteration for the polar factor, Q <-
/// (Q + Q^-T)/2 [Higham86]; its components are rounded once. The axes must be linearly independent and
/// right-handed.
Frame closestRotation(Twofold3 x, Twofold3 y, Twofold3 z);

} // namespace yarte
