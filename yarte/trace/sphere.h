// Sphere: the points at distance `radius` from `centre`.
#pragma once

#include "yarte/scene/shapes.h"
#include "yarte/trace/bounds.h"
#include "yarte/trace/ray.h"

namespace yarte::trace {

struct Sphere {
    static constexpr bool isFlat = false, isClosed = true;

    Vec3 centre;
    double radius;

    explicit Sphere(const yarte::Sphere& s) : centre(s.centre), radius(s.radius) {}
};

inline Bounds bounds(const Sphere& s) {
    const Vec3 r{s.radius, s.radius, s.radius};
    return {s.centre - r, s.centre + r};
}

/// With u = origin - centre and b = -u.d, the line's point nearest to the centre is u + b d; the discriminant
/// from it, r^2 - |u + b d|^2, does not cancel for small or distant spheres, nor do the roots b + h and (u.u
/// - r^2)/(b + h) [Haines, Guenther, Akenine-Moeller, "Precision Improvements for Ray/Sphere Intersection",
/// Ray Tracing Gems 7].
///
/// The point nearest is good to some 2^-51 |b|, which moves the discriminant by twice that times r; whether
/// the start is inside is the sign of u.u - r^2, good to 2^-51 r^2 where that is in doubt.
inline Crossings quickCrossings(const Sphere& s, const Ray& ray) {
    Crossings result;
    const Vec3 u = ray.origin - s.centre;
    const double b = -dot(u, ray.direction);
    const Vec3 nearest = u + b * ray.direction;
    const double discriminant = s.radius * s.radius - dot(nearest, nearest);
    const double blur = 0x1p-30 * s.radius * s.radius + 0x1p-44 * s.radius * std::abs(b);
    if (discriminant < -blur) return result;
    const double c = dot(u, u) - s.radius * s.radius;
    result.isDoubtful = discriminant <= blur || std::abs(c) <= 0x1p-44 * s.radius * s.radius;
    if (discriminant < 0) return result;
    const double h = std::sqrt(discriminant);
    const double large = b < 0 ? b - h : b + h;
    const double small = large != 0 ? c / large : 0;
    result.add(std::min(large, small), 0, true);
    result.add(std::max(large, small), 0, false);
    return result;
}

Crossings carefulCrossings(const Sphere&, const Ray&);

inline Vec3 outwardNormal(const Sphere& s, Vec3 point, std::uint8_t) { return normalised(point - s.centre); }

} // namespace yarte::trace
