// Frustum: a cone without its tip, or a cylinder, closed by its two discs; axis +y of its own axes. Part 0 is
// the lateral surface, part 1 the base, part 2 the top.
#pragma once

#include "yarte/base/frame.h"
#include "yarte/scene/shapes.h"
#include "yarte/trace/nappe.h"
#include "yarte/trace/ray.h"

#include <utility>

namespace yarte::trace {

struct Frustum {
    static constexpr bool isFlat = false, isClosed = true;

    Vec3 centre; ///< of the base
    double baseRadius, topRadius, height;
    Nappe nappe; ///< given at the end of the smaller radius, which would be lost against the larger
    Frame axes;

    Frustum(const yarte::Frustum& f, const Frame& frame)
        : centre(f.centre), baseRadius(f.baseRadius), topRadius(f.topRadius),
          height(f.height), nappe{(f.baseRadius - f.topRadius) / f.height,
                                  f.baseRadius < f.topRadius ? 0 : f.height,
                                  std::min(f.baseRadius, f.topRadius)},
          axes(frame) {}
    Frustum(const yarte::Cylinder& c, const Frame& frame)
        : Frustum(yarte::Frustum{c.centre, c.radius, c.radius, c.height}, frame) {}
};

inline Bounds bounds(const Frustum& f) {
    Bounds result = boundsOfCircle(f.centre, f.baseRadius, f.axes.y);
    result.add(boundsOfCircle(f.centre + f.axes.y * f.height, f.topRadius, f.axes.y));
    return result;
}

/// The stretch inside the nappe cut by the slab between the discs; as of a cone, a line that enters always
/// leaves. A line parallel to the slab is inside it everywhere or nowhere.
inline Crossings quickCrossings(const Frustum& f, const Ray& ray) {
    const LocalLine line(ray, f.centre, f.axes, f.baseRadius + f.topRadius, f.height);
    const Vec3 p = line.p, d = line.d;
    Stretch inside = stretchInNappe(line, f.nappe);
    std::uint8_t enterPart = 0, leavePart = 0;
    Crossings result;
    result.isDoubtful = inside.isDoubtful || inside.endsAt(0, line) || inside.endsAt(f.height, line) ||
                        inside.endsAtStart(line);
    const double nearestDisc = std::min(std::abs(p.y), std::abs(p.y - f.height));
    if (d.y == 0) {
        result.isDoubtful |= nearestDisc <= inside.blur;
        if (p.y < 0 || p.y > f.height) return result;
    } else {
        double enter = -p.y / d.y, leave = (f.height - p.y) / d.y;
        const bool isUpwards = d.y > 0;
        if (!isUpwards) std::swap(enter, leave);
        if (enter > inside.from) inside.from = enter, enterPart = isUpwards ? 1 : 2;
        if (leave < inside.to) inside.to = leave, leavePart = isUpwards ? 2 : 1;
        result.isDoubtful |= (enterPart != 0 || leavePart != 0) && nearestDisc <= inside.blur;
    }
    if (inside.empty()) return result;
    result.add(line.moved + inside.from, enterPart, true);
    result.add(line.moved + inside.to, leavePart, false);
    return result;
}

Crossings carefulCrossings(const Frustum&, const Ray&);

inline Vec3 outwardNormal(const Frustum& f, Vec3 point, std::uint8_t part) {
    if (part != 0) return part == 1 ? -f.axes.y : f.axes.y;
    return f.axes.toWorld(nappeNormal(f.axes.toLocal(point - f.centre), f.nappe));
}

} // namespace yarte::trace
