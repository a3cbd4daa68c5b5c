// Box: a rectangular block in its own axes. Part 2 i is the face on the low side of axis i, 2 i + 1 on its
// high side.
#pragma once

#include "yarte/base/frame.h"
#include "yarte/scene/shapes.h"
#include "yarte/trace/bounds.h"
#include "yarte/trace/ray.h"

#include <utility>

namespace yarte::trace {

struct Box {
    static constexpr bool isFlat = false, isClosed = true;

    Vec3 centre, half; ///< half: half the side lengths
    Frame axes;
    double blur; ///< of distances along a ray, relative to the largest one

    Box(const yarte::Box& b, const Frame& frame)
        : centre(b.centre), half(b.sides / 2), axes(frame),
          blur(0x1p-20 +
               0x1p-44 * (std::max({half.x, half.y, half.z}) / std::min({half.x, half.y, half.z}))) {}
};

inline Bounds bounds(const Box& b) {
    const auto reach = [&](double x, double y, double z) {
        return std::abs(x) * b.half.x + std::abs(y) * b.half.y + std::abs(z) * b.half.z;
    };
    const Vec3 extent{reach(b.axes.x.x, b.axes.y.x, b.axes.z.x), reach(b.axes.x.y, b.axes.y.y, b.axes.z.y),
                      reach(b.axes.x.z, b.axes.y.z, b.axes.z.z)};
    return {b.centre - extent, b.centre + extent};
}

/// The line is inside the box where it is inside all three slabs: the intersection of three intervals
/// [Kay & Kajiya 1986]. A line parallel to a slab is inside it everywhere or nowhere.
///
/// Which slabs come first is in doubt where two are entered (or left) at nearly the same t, that is, next to
/// an edge, where one is entered as another is left, or where the line is parallel to one. A quotient is good
/// to some ulps of the largest distance to a face over the slope; thin boxes, whose faces are near but whose
/// coordinates are rounded by their length, allow for that.
inline Crossings quickCrossings(const Box& b, const Ray& ray) {
    const Vec3 localOrigin = b.axes.toLocal(ray.origin - b.centre);
    const Vec3 localDirection = b.axes.toLocal(ray.direction);
    const double origin[3] = {localOrigin.x, localOrigin.y, localOrigin.z};
    const double direction[3] = {localDirection.x, localDirection.y, localDirection.z};
    const double half[3] = {b.half.x, b.half.y, b.half.z};

    double enter = -Bounds::infinity, leave = Bounds::infinity;
    double secondEnter = -Bounds::infinity, secondLeave = Bounds::infinity, farthest = 0;
    bool isBeside = false, isParallel = false;
    std::uint8_t enterPart = 0, leavePart = 0;
    for (std::uint8_t axis = 0; axis < 3; ++axis) {
        if (direction[axis] == 0) {
            isParallel = true;
            isBeside |= std::abs(origin[axis]) > half[axis];
            continue;
        }
        double low = (-half[axis] - origin[axis]) / direction[axis];
        double high = (half[axis] - origin[axis]) / direction[axis];
        std::uint8_t lowPart = static_cast<std::uint8_t>(2 * axis),
                     highPart = static_cast<std::uint8_t>(lowPart + 1);
        if (low > high) std::swap(low, high), std::swap(lowPart, highPart);
        farthest = std::max(farthest, std::max(std::abs(low), std::abs(high)));
        secondEnter = std::max(secondEnter, std::min(low, enter));
        secondLeave = std::min(secondLeave, std::max(high, leave));
        if (low > enter) enter = low, enterPart = lowPart;
        if (high < leave) leave = high, leavePart = highPart;
    }
    Crossings result;
    const double nearest = std::min({std::abs(leave - enter), enter - secondEnter, secondLeave - leave,
                                     std::abs(enter), std::abs(leave)});
    result.isDoubtful = isParallel || nearest <= farthest * b.blur;
    if (isBeside || enter > leave) return result;
    result.add(enter, enterPart, true);
    result.add(leave, leavePart, false);
    return result;
}

Crossings carefulCrossings(const Box&, const Ray&);

inline Vec3 outwardNormal(const Box& b, Vec3, std::uint8_t part) {
    const Vec3 axis = part < 2 ? b.axes.x : part < 4 ? b.axes.y : b.axes.z;
    return part % 2 == 0 ? -axis : axis;
}

} // namespace yarte::trace
