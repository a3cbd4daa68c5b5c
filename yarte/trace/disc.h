// Disc: a filled circle; its normal is the +y of its own axes.
#pragma once

#include "yarte/base/frame.h"
#include "yarte/scene/shapes.h"
#include "yarte/trace/bounds.h"
#include "yarte/trace/ray.h"

namespace yarte::trace {

struct Disc {
    static constexpr bool isFlat = true, isClosed = false;

    Vec3 centre, normal;
    double radius;

    Disc(const yarte::Disc& d, const Frame& frame) : centre(d.centre), normal(frame.y), radius(d.radius) {}
};

inline Bounds bounds(const Disc& d) { return boundsOfCircle(d.centre, d.radius, d.normal); }

/// The point in the plane is good to some 2^-50 |u| / fall; the side of the plane that the ray starts on is
/// the sign of u.n.
inline Crossings quickCrossings(const Disc& d, const Ray& ray) {
    Crossings result;
    const Vec3 u = ray.origin - d.centre;
    const double fall = -dot(ray.direction, d.normal);
    const double height = dot(u, d.normal), far = std::abs(u.x) + std::abs(u.y) + std::abs(u.z);
    const double t = height / fall;
    const Vec3 fromCentre = u + t * ray.direction;
    const double margin = d.radius * d.radius - dot(fromCentre, fromCentre), slope = std::abs(fall);
    result.isDoubtful = slope <= 0x1p-40 ||
                        std::abs(margin) * slope <= d.radius * (0x1p-26 * d.radius + 0x1p-44 * far) ||
                        (margin >= 0 && std::abs(height) <= 0x1p-44 * far);
    if (fall != 0 && margin >= 0) result.add(t, 0, fall > 0);
    return result;
}

Crossings carefulCrossings(const Disc&, const Ray&);

inline Vec3 outwardNormal(const Disc& d, Vec3, std::uint8_t) { return d.normal; }

} // namespace yarte::trace
