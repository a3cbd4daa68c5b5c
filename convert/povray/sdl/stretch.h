// How an affine map changes shapes: whether round stays round, and what is nearest where it does not.
#pragma once

#include "convert/povray/sdl/affine.h"
#include "yarte/scene/shapes.h"

#include <optional>

namespace yarte::convert::povray::sdl {

/// Robust against overflow, and exact along an axis.
double lengthOf(Vec3);
/// Of any finite vector but 0; one along an axis is exact.
Vec3 unit(Vec3);
/// A unit vector perpendicular to the unit vector `d`; one of the axes if `d` is one.
Vec3 perpendicular(Vec3 d);

/// By how much the map scales all lengths, and what part of any length that is wrong by.
struct Similarity {
    double scale = 1;
    double error = 0;
};
Similarity similarityOf(const Affine&);

/// The longest image of a unit vector, or a little more.
double largestStretch(const Affine&);

/// Relative errors up to this are rounding: transformations are products of many factors.
inline constexpr double rounding = 1e-12;

/// Axes for a body of revolution around `axis`, which is of unit length; none if it is +y.
std::optional<Referential> axesAlong(Vec3 axis);

} // namespace yarte::convert::povray::sdl
