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

inline Crossings crossings(const Disc& d, const Ray& ray) {
    Crossings result;
    const Vec3 u = ray.origin - d.centre;
    const double fall = -dot(ray.direction, d.normal);
    if (fall == 0) return result;
    const double t = dot(u, d.normal) / fall;
    const Vec3 fromCentre = u + t * ray.direction;
    if (dot(fromCentre, fromCentre) <= d.radius * d.radius) result.add(t, 0, fall > 0);
    return result;
}

inline Vec3 outwardNormal(const Disc& d, Vec3, std::uint8_t) { return d.normal; }

} // namespace yarte::trace
