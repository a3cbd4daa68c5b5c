// Affine: an affine map as POV-Ray writes it, for row vectors: p' = p.x*x + p.y*y + p.z*z + t.
#pragma once

#include "yarte/base/vec3.h"

#include <optional>

namespace yarte::convert::povray::sdl {

struct Affine {
    Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1}, t{};
    friend bool operator==(const Affine&, const Affine&) = default;
};

Vec3 mapPoint(const Affine&, Vec3);
Vec3 mapDirection(const Affine&, Vec3);
/// A normal's direction: by the inverse transposed, not normalised; keeps its side under mirroring.
Vec3 mapNormal(const Affine&, Vec3);
double determinant(const Affine&);

/// First `a`, then `b`. A map that is the identity changes no bit of the other, nor does a move of the
/// origin.
Affine then(const Affine& a, const Affine& b);
/// None if `a` flattens space.
std::optional<Affine> inverse(const Affine& a);

Affine translation(Vec3);
/// A component 0 becomes 1, as in POV-Ray.
Affine scaling(Vec3);
/// About x, then y, then z, by degrees, left-handed as POV-Ray's axes are.
Affine rotation(Vec3 degrees);
/// About `axis`, which need not be of unit length.
Affine axisRotation(Vec3 axis, double degrees);

} // namespace yarte::convert::povray::sdl
