// TruncatedCone: the lateral surface of a cone or cylinder between its base and `height`; open at both ends,
// axis +y of its own axes.
#pragma once

#include "yarte/base/frame.h"
#include "yarte/scene/shapes.h"
#include "yarte/trace/nappe.h"
#include "yarte/trace/ray.h"

namespace yarte::trace {

struct TruncatedCone {
    static constexpr bool isFlat = false, isClosed = false;

    Vec3 centre;                        ///< of the base
    double radius, upperRadius, height; ///< radius: of the base
    Nappe nappe;
    Frame axes;

    TruncatedCone(const yarte::TruncatedCone& c, const Frame& frame)
        : TruncatedCone(c.centre, c.radius, c.height, {c.radius / c.coneHeight, c.coneHeight, 0}, frame) {}
    TruncatedCone(const yarte::OpenCylinder& c, const Frame& frame)
        : TruncatedCone(c.centre, c.radius, c.height, {0, c.height, c.radius}, frame) {}

private:
    TruncatedCone(Vec3 centre_, double radius_, double height_, const Nappe& n, const Frame& frame)
        : centre(centre_), radius(radius_), upperRadius(n.radius + n.slope * (n.height - height_)),
          height(height_), nappe(n), axes(frame) {}
};

inline Bounds bounds(const TruncatedCone& c) {
    Bounds result = boundsOfCircle(c.centre, c.radius, c.axes.y);
    result.add(boundsOfCircle(c.centre + c.axes.y * c.height, c.upperRadius, c.axes.y));
    return result;
}

/// The ends of the stretch inside the nappe, each kept if it lies between the two rims.
inline Crossings quickCrossings(const TruncatedCone& c, const Ray& ray) {
    const LocalLine line(ray, c.centre, c.axes, c.radius, c.height);
    const Vec3 p = line.p, d = line.d;
    const Stretch inside = stretchInNappe(line, c.nappe);
    Crossings result;
    result.isDoubtful = inside.isDoubtful || inside.endsAt(0, line) || inside.endsAt(c.height, line) ||
                        inside.endsAtStart(line);
    if (inside.empty()) return result;
    const auto isKept = [&](double t) {
        const double y = p.y + t * d.y;
        return std::isfinite(t) && y >= 0 && y <= c.height;
    };
    if (isKept(inside.from)) result.add(line.moved + inside.from, 0, true);
    if (isKept(inside.to)) result.add(line.moved + inside.to, 0, false);
    return result;
}

Crossings carefulCrossings(const TruncatedCone&, const Ray&);

inline Vec3 outwardNormal(const TruncatedCone& c, Vec3 point, std::uint8_t) {
    return c.axes.toWorld(nappeNormal(c.axes.toLocal(point - c.centre), c.nappe));
}

} // namespace yarte::trace
