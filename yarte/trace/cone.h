// Cone: closed by its base disc, axis +y of its own axes. Part 0 is the lateral surface, part 1 the base.
#pragma once

#include "yarte/base/frame.h"
#include "yarte/scene/shapes.h"
#include "yarte/trace/nappe.h"
#include "yarte/trace/ray.h"

namespace yarte::trace {

struct Cone {
    static constexpr bool isFlat = false, isClosed = true;

    Vec3 centre; ///< of the base
    double radius, height;
    Nappe nappe;
    Frame axes;

    Cone(const yarte::Cone& c, const Frame& frame)
        : centre(c.centre), radius(c.radius), height(c.height), nappe{c.radius / c.height, c.height, 0},
          axes(frame) {}
};

inline Bounds bounds(const Cone& c) {
    Bounds result = boundsOfCircle(c.centre, c.radius, c.axes.y);
    result.add(c.centre + c.axes.y * c.height);
    return result;
}

/// The stretch inside the nappe cut by the half-space above the base. Working with stretches instead of two
/// surfaces leaves no crack at the rim: a line that enters always leaves.
/// In doubt next to the rim, too.
inline Crossings quickCrossings(const Cone& c, const Ray& ray) {
    const LocalLine line(ray, c.centre, c.axes, c.radius, c.height);
    const Vec3 p = line.p, d = line.d;
    Stretch inside = stretchInNappe(line, c.nappe);
    std::uint8_t enterPart = 0, leavePart = 0;
    Crossings result;
    result.isDoubtful = inside.isDoubtful || inside.endsAt(0, line) || inside.endsAtStart(line);
    if (d.y == 0) {
        if (p.y < 0) return result;
    } else {
        const double base = -p.y / d.y;
        if (d.y > 0 && base > inside.from) inside.from = base, enterPart = 1;
        if (d.y < 0 && base < inside.to) inside.to = base, leavePart = 1;
        result.isDoubtful |= (enterPart == 1 || leavePart == 1) && std::abs(p.y) <= inside.blur;
    }
    if (inside.empty()) return result;
    result.add(line.moved + inside.from, enterPart, true);
    result.add(line.moved + inside.to, leavePart, false);
    return result;
}

Crossings carefulCrossings(const Cone&, const Ray&);

inline Vec3 outwardNormal(const Cone& c, Vec3 point, std::uint8_t part) {
    if (part == 1) return -c.axes.y;
    return c.axes.toWorld(nappeNormal(c.axes.toLocal(point - c.centre), c.nappe));
}

} // namespace yarte::trace
