// Plane: all points p with n.p = distance; infinite, and therefore in no tree. Its inside is where n.p is
// less.
#pragma once

#include "yarte/base/twofold.h"
#include "yarte/scene/shapes.h"
#include "yarte/trace/ray.h"

#include <cmath>

namespace yarte::trace {

struct Plane {
    static constexpr bool isFlat = true, isClosed = false;

    Vec3 normal; ///< unit
    double distance;

    explicit Plane(const yarte::Plane& p)
        : normal(preciseUnitVector(p.normal).rounded()), distance(p.distance) {}
};

/// How far a point is in front of the plane; negative inside.
inline double heightAbove(const Plane& s, Vec3 point) { return dot(point, s.normal) - s.distance; }

/// Flat: a ray that starts on it never meets it again, so nothing depends on which side rounding puts the
/// start. A line so nearly parallel that t is beyond all numbers does not meet it.
inline Crossings quickCrossings(const Plane& s, const Ray& ray) {
    Crossings result;
    const double fall = -dot(ray.direction, s.normal), height = heightAbove(s, ray.origin);
    const Vec3 o = ray.origin;
    const double far = std::abs(o.x) + std::abs(o.y) + std::abs(o.z) + std::abs(s.distance);
    result.isDoubtful = std::abs(fall) <= 0x1p-40 || std::abs(height) <= 0x1p-44 * far;
    const double t = height / fall;
    if (std::isfinite(t)) result.add(t, 0, fall > 0);
    return result;
}

Crossings carefulCrossings(const Plane&, const Ray&);

inline Vec3 outwardNormal(const Plane& s, Vec3, std::uint8_t) { return s.normal; }

} // namespace yarte::trace
