// Tessellation: shapes as triangles, for formats that know nothing else.
//
// Every shape is made in its local axes around its own middle, where float32 is most precise: a sphere, box
// or disc around its centre, cones and cylinders around the middle of their axis.
#pragma once

#include "yarte/base/vec3.h"

#include <array>
#include <cstdint>
#include <vector>

namespace yarte::convert {

using Vec3f = std::array<float, 3>;

struct Tessellation {
    std::vector<Vec3f> positions;
    std::vector<Vec3f> normals; ///< unit, as `positions`; empty: the triangles are flat
    /// Counter-clockwise seen from the front; at least one, if only to have something to show.
    std::vector<std::array<std::uint32_t, 3>> triangles;
    /// Measured on the positions as rounded: no point of either surface is farther than this from the other.
    double deviation = 0;
};

/// Unless the user says otherwise; a part of the radius.
inline constexpr double defaultChordError = 1e-3;

/// Chord errors below this part of the radius are taken as it: near it, float32 limits what is reached, and a
/// sphere has 1.6 million triangles.
inline constexpr double leastRelativeChordError = 4e-6;

Tessellation tessellateSphere(double radius, double chordError);
Tessellation tessellateBox(Vec3 sides);
struct Lids {
    bool bottom = false, top = false;
};
/// Axis +y, from the radius `bottom` to `top`, which may be 0; `lids`: the discs that close it.
Tessellation tessellateCone(double bottom, double top, double height, Lids lids, double chordError);
Tessellation tessellateDisc(double radius, double chordError);
/// With the normal +y and sides of length 2 * `reach`.
Tessellation tessellateSquare(double reach);

Vec3f rounded(Vec3); ///< what is beyond float32 becomes its largest number
Vec3 widened(const Vec3f&);

} // namespace yarte::convert
