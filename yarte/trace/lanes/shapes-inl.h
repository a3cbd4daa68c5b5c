// One kernel per shape, for as many rays as the machine has lanes. Each computes what the scalar
// `quickCrossings` in the shape's own header computes, in the same order, so to the last bit; the derivations
// are there.
#if defined(YARTE_TRACE_LANES_SHAPES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef YARTE_TRACE_LANES_SHAPES_INL_H
#undef YARTE_TRACE_LANES_SHAPES_INL_H
#else
#define YARTE_TRACE_LANES_SHAPES_INL_H
#endif

#include "yarte/trace/box.h"
#include "yarte/trace/cone.h"
#include "yarte/trace/disc.h"
#include "yarte/trace/frustum.h"
#include "yarte/trace/lanes/packet-inl.h"
#include "yarte/trace/plane.h"
#include "yarte/trace/sphere.h"
#include "yarte/trace/truncated_cone.h"

HWY_BEFORE_NAMESPACE();
namespace yarte::trace::HWY_NAMESPACE::YARTE_PRECISION {

HWY_INLINE CrossingLanes noCrossings() { return {set(0), set(0), set(0), set(0), none(), none(), none()}; }

/// Lanes that cross a shape for sure or, where somebody decides again, perhaps. In float nobody does: what is
/// in doubt is not asked for, and costs nothing.
HWY_INLINE M possible(M sure, M doubtful) {
    if constexpr (isFloat) return sure;
    return hn::Or(sure, doubtful);
}

HWY_INLINE CrossingLanes crossings(const Sphere& s, V3 origin, V3 direction) {
    const V radius2 = set(s.radius * s.radius);
    const V3 u = origin - spread(s.centre);
    const V b = hn::Neg(dot(u, direction));
    const V3 nearest = u + direction * b;
    const V discriminant = radius2 - dot(nearest, nearest);
    const V blur = set(0x1p-30 * s.radius * s.radius) + set(0x1p-44 * s.radius) * hn::Abs(b);
    const M hits = discriminant >= set(0), near = discriminant >= hn::Neg(blur);
    if (!any(isFloat ? hits : near)) return noCrossings();
    const V c = dot(u, u) - radius2;
    const M doubtful =
        hn::And(near, hn::Or(discriminant <= blur, hn::Abs(c) <= set(0x1p-44 * s.radius * s.radius)));
    const V h = hn::Sqrt(greatest(discriminant, set(0)));
    const V large = select(b < set(0), b - h, b + h);
    const V small = select(large != set(0), c / large, set(0));
    return {least(large, small), greatest(large, small), set(0), set(0), hits, hits, doubtful};
}

/// What comes second, and how far things are: what a box's doubt depends on.
struct SlabDistances {
    V secondEnter, secondLeave, farthest;
};

/// One slab of a box: narrows enter and leave, or rules the lane out.
HWY_INLINE void clipToSlab(V origin, V direction, double halfSide, double lowPart, CrossingLanes& c,
                           SlabDistances& s) {
    const V h = set(halfSide);
    const M parallel = direction == set(0);
    const M outside = hn::And(parallel, hn::Abs(origin) > h);
    c.doubtful = hn::Or(c.doubtful, parallel);
    const V a = (hn::Neg(h) - origin) / direction, b = (h - origin) / direction;
    const M swapped = a > b;
    const V low = select(swapped, b, a), high = select(swapped, a, b);
    const V lowSide = select(swapped, set(lowPart + 1), set(lowPart));
    const V highSide = select(swapped, set(lowPart), set(lowPart + 1));
    s.farthest = hn::Max(s.farthest, hn::Max(hn::Abs(low), hn::Abs(high)));
    s.secondEnter = hn::Max(s.secondEnter, hn::Min(low, c.enter));
    s.secondLeave = hn::Min(s.secondLeave, hn::Max(high, c.leave));
    const M later = hn::AndNot(parallel, low > c.enter), earlier = hn::AndNot(parallel, high < c.leave);
    c.enter = select(later, low, c.enter), c.enterPart = select(later, lowSide, c.enterPart);
    c.leave = select(earlier, high, c.leave), c.leavePart = select(earlier, highSide, c.leavePart);
    c.enters = hn::AndNot(outside, c.enters);
}

HWY_INLINE CrossingLanes crossings(const Box& b, V3 worldOrigin, V3 worldDirection) {
    const V3 origin = toLocal(b.axes, worldOrigin - spread(b.centre)),
             direction = toLocal(b.axes, worldDirection);
    CrossingLanes c{set(-Bounds::infinity), set(Bounds::infinity), set(0), set(0),
                    set(0) == set(0),       set(0) == set(0),      none()};
    SlabDistances s{c.enter, c.leave, set(0)};
    clipToSlab(origin.x, direction.x, b.half.x, 0, c, s);
    clipToSlab(origin.y, direction.y, b.half.y, 2, c, s);
    clipToSlab(origin.z, direction.z, b.half.z, 4, c, s);
    const V nearest = hn::Min(
        hn::Min(hn::Abs(c.leave - c.enter), hn::Min(c.enter - s.secondEnter, s.secondLeave - c.leave)),
        hn::Min(hn::Abs(c.enter), hn::Abs(c.leave)));
    c.doubtful = hn::Or(c.doubtful, nearest <= s.farthest * set(b.blur));
    c.enters = hn::And(c.enters, c.enter <= c.leave);
    c.leaves = c.enters;
    return c;
}

/// As LocalLine.
struct LocalLines {
    V3 p, d;
    V moved, far;
    double reach;

    template <class Axes>
    HWY_INLINE LocalLines(V3 origin, V3 direction, Vec3 centre, const Axes& axes, double radius,
                          double height)
        : reach(radius + height) {
        const V3 u = origin - spread(centre);
        d = toLocal(axes, direction);
        const V beside = least(greatest(dot(u, spread(axes.y)), set(0)), set(height));
        const V nearest = beside * d.y - dot(u, direction);
        moved = select(hn::Abs(nearest) > set(1.5 * radius), nearest, set(0));
        p = toLocal(axes, u + direction * moved);
        far = set(2.5 * reach) + hn::Abs(moved);
    }
};

/// As Stretch.
struct StretchLanes {
    V from, to;
    M doubtful;
    V blur, steepness;

    HWY_INLINE V distanceTo(double height, const LocalLines& line) const {
        const V y = line.p.y, dy = line.d.y, h = set(height);
        return hn::Min(hn::Abs(y + from * dy - h), hn::Abs(y + to * dy - h));
    }
    HWY_INLINE V distanceToStart(const LocalLines& line) const {
        return hn::Min(hn::Abs(line.moved + from), hn::Abs(line.moved + to));
    }
    /// An end is at one of these distances from a decision.
    HWY_INLINE M endsAt(V distance) const { return distance * steepness <= blur; }
};

HWY_INLINE StretchLanes emptyStretch() {
    return {set(Bounds::infinity), set(-Bounds::infinity), none(), set(0), set(0)};
}

HWY_INLINE StretchLanes stretchInCylinder(const LocalLines& line, double radius) {
    const V3 p = line.p, d = line.d;
    const V zero = set(0), r2 = set(radius * radius);
    const V a = d.x * d.x + d.z * d.z, b = p.x * d.x + p.z * d.z, c = p.x * p.x + p.z * p.z - r2;
    const V xz = p.x * d.z - p.z * d.x;
    const V discriminant = r2 * a - xz * xz;

    const V k = set(radius) + hn::Abs(xz), w = set(0x1p-24) * k + set(0x1p-43) * line.far;
    const M hits = discriminant >= zero, along = a == zero;
    const M doubtful = hn::Or(hn::Abs(discriminant) <= (k + w) * w, along);
    if (!any(possible(hits, doubtful))) return emptyStretch();
    const V h = hn::Sqrt(greatest(discriminant, zero)), sum = hn::Neg(select(b < zero, b - h, b + h));
    const V root1 = sum / a, root2 = select(sum != zero, c / sum, root1);
    const V infinity = set(Bounds::infinity), minusInfinity = set(-Bounds::infinity);
    V from = select(hits, least(root1, root2), infinity),
      to = select(hits, greatest(root1, root2), minusInfinity);
    if (any(along)) [[unlikely]] {
        const M inside = c <= zero;
        from = select(along, select(inside, minusInfinity, infinity), from);
        to = select(along, select(inside, infinity, minusInfinity), to);
    }
    return {from, to, doubtful, set(0x1p-26 * line.reach) + set(0x1p-42) * line.far, a};
}

HWY_INLINE StretchLanes stretchInCone(const LocalLines& line, const Nappe& nappe) {
    const V3 p = line.p, d = line.d;
    const V zero = set(0), slope = set(nappe.slope);
    const V start = slope * (set(nappe.height) - p.y) + set(nappe.radius), dr = slope * hn::Neg(d.y);
    const V dd = d.x * d.x + d.z * d.z, m = dd + dr * dr;
    const V moved = hn::Neg(p.x * d.x + p.z * d.z + start * dr) / m;
    const V x = p.x + moved * d.x, y = p.y + moved * d.y, z = p.z + moved * d.z;
    const V r = slope * (set(nappe.height) - y) + set(nappe.radius);

    const V a = dd - dr * dr, b = x * d.x + z * d.z - r * dr, c = x * x + z * z - r * r;
    const V xr = x * dr - r * d.x, zr = z * dr - r * d.z, xz = x * d.z - z * d.x;
    const V discriminant = xr * xr + zr * zr - xz * xz;

    const V far = line.far + hn::Abs(start), k = hn::Abs(xr) + hn::Abs(zr) + hn::Abs(xz);
    const V w = set(0x1p-24) * k + set(0x1p-44 * (2 + nappe.slope * nappe.slope)) * far;
    const M near = hn::Abs(discriminant) <= (k + w) * w;
    if (!any(possible(hn::Or(a <= zero, discriminant >= zero), near))) return emptyStretch();
    const V blur = set(0x1p-26 * line.reach) + set(0x1p-42) * far, steepness = hn::Min(set(1), hn::Abs(a));
    const M doubtful = hn::Or(near, hn::Or(hn::Abs(a) <= set(0x1p-16) * m, hn::Abs(r) <= set(0x1p-40) * far));

    const V infinity = set(Bounds::infinity), minusInfinity = set(-Bounds::infinity);
    const V h = hn::Sqrt(greatest(discriminant, zero)), sum = hn::Neg(select(b < zero, b - h, b + h));
    const V root1 = sum / a, root2 = select(sum != zero, c / sum, root1);
    const V low = moved + least(root1, root2), high = moved + greatest(root1, root2);
    const M both = hn::And(a > zero, hn::And(discriminant >= zero, r > zero));
    const M steep = a<zero, down = dr> zero;

    // Empty unless one of the cases of the scalar form applies.
    V from = infinity, to = minusInfinity;
    from = select(both, low, from), to = select(both, high, to);
    from = select(steep, select(down, high, minusInfinity), from),
    to = select(steep, select(down, infinity, low), to);
    const M linear = a == zero;
    if (any(linear)) [[unlikely]] {
        const V single = moved - c / (set(2) * b);
        const M below = hn::And(b<zero, dr> zero), above = hn::And(b > zero, dr < zero);
        from = select(linear, select(below, single, select(above, minusInfinity, infinity)), from);
        to = select(linear, select(below, infinity, select(above, single, minusInfinity)), to);
    }
    return {from, to, doubtful, blur, steepness};
}

HWY_INLINE StretchLanes stretchInNappe(const LocalLines& line, const Nappe& nappe) {
    return nappe.slope == 0 ? stretchInCylinder(line, nappe.radius) : stretchInCone(line, nappe);
}

HWY_INLINE CrossingLanes crossings(const Cone& c, V3 origin, V3 direction) {
    const V zero = set(0), one = set(1);
    const LocalLines line(origin, direction, c.centre, c.axes, c.radius, c.height);
    const V3 p = line.p, d = line.d;
    const StretchLanes inside = stretchInNappe(line, c.nappe);
    V from = inside.from, to = inside.to;
    const V base = hn::Neg(p.y) / d.y;
    const M baseEnters = hn::And(d.y > zero, base > from), baseLeaves = hn::And(d.y < zero, base < to);
    from = select(baseEnters, base, from), to = select(baseLeaves, base, to);
    const M beside = hn::And(d.y == zero, p.y < zero);
    const M hits = hn::AndNot(beside, from <= to);
    const M startsAtBase = hn::And(hn::Or(baseEnters, baseLeaves), hn::Abs(p.y) <= inside.blur);
    const V nearest = hn::Min(inside.distanceTo(0, line), inside.distanceToStart(line));
    const M doubtful = hn::Or(hn::Or(inside.doubtful, startsAtBase), inside.endsAt(nearest));
    return {line.moved + from,
            line.moved + to,
            select(baseEnters, one, zero),
            select(baseLeaves, one, zero),
            hits,
            hits,
            doubtful};
}

HWY_INLINE CrossingLanes crossings(const Frustum& f, V3 origin, V3 direction) {
    const V zero = set(0), one = set(1), two = set(2);
    const LocalLines line(origin, direction, f.centre, f.axes, f.baseRadius + f.topRadius, f.height);
    const V3 p = line.p, d = line.d;
    const StretchLanes inside = stretchInNappe(line, f.nappe);
    V from = inside.from, to = inside.to;
    const V base = hn::Neg(p.y) / d.y, top = (set(f.height) - p.y) / d.y;
    const M upwards = d.y > zero, level = d.y == zero;
    const V enter = select(upwards, base, top), leave = select(upwards, top, base);
    const M later = hn::AndNot(level, enter > from), earlier = hn::AndNot(level, leave < to);
    from = select(later, enter, from), to = select(earlier, leave, to);
    const M beside = hn::And(level, hn::Or(p.y<zero, p.y> set(f.height)));
    const M hits = hn::AndNot(beside, from <= to);
    const M startsAtDisc = hn::And(hn::Or(level, hn::Or(later, earlier)),
                                   hn::Min(hn::Abs(p.y), hn::Abs(p.y - set(f.height))) <= inside.blur);
    const V nearest = hn::Min(hn::Min(inside.distanceTo(0, line), inside.distanceTo(f.height, line)),
                              inside.distanceToStart(line));
    const M doubtful = hn::Or(hn::Or(inside.doubtful, startsAtDisc), inside.endsAt(nearest));
    return {line.moved + from,
            line.moved + to,
            select(later, select(upwards, one, two), zero),
            select(earlier, select(upwards, two, one), zero),
            hits,
            hits,
            doubtful};
}

HWY_INLINE CrossingLanes crossings(const TruncatedCone& c, V3 origin, V3 direction) {
    const V zero = set(0), height = set(c.height), infinity = set(Bounds::infinity);
    const LocalLines line(origin, direction, c.centre, c.axes, c.radius, c.height);
    const V3 p = line.p, d = line.d;
    const StretchLanes inside = stretchInNappe(line, c.nappe);
    const V from = inside.from, to = inside.to;
    const M hits = from <= to;
    const V fromY = p.y + from * d.y, toY = p.y + to * d.y;
    const M keepsFrom = hn::And(hn::Abs(from) < infinity, hn::And(fromY >= zero, fromY <= height));
    const M keepsTo = hn::And(hn::Abs(to) < infinity, hn::And(toY >= zero, toY <= height));
    const V nearest = hn::Min(hn::Min(inside.distanceTo(0, line), inside.distanceTo(c.height, line)),
                              inside.distanceToStart(line));
    const M doubtful = hn::Or(inside.doubtful, inside.endsAt(nearest));
    return {line.moved + from,        line.moved + to,        zero,    zero,
            hn::And(hits, keepsFrom), hn::And(hits, keepsTo), doubtful};
}

/// A flat shape is crossed once, one way or the other.
HWY_INLINE CrossingLanes onceCrossed(V t, V fall, M hits, M doubtful) {
    const M enters = fall > set(0);
    return {t, t, set(0), set(0), hn::And(hits, enters), hn::AndNot(enters, hits), doubtful};
}
HWY_INLINE V sumOfSizes(V3 v) { return hn::Abs(v.x) + hn::Abs(v.y) + hn::Abs(v.z); }

HWY_INLINE CrossingLanes crossings(const Disc& s, V3 origin, V3 direction) {
    const V3 normal = spread(s.normal), u = origin - spread(s.centre);
    const V fall = hn::Neg(dot(direction, normal));
    const V height = dot(u, normal), far = sumOfSizes(u);
    const V t = height / fall;
    const V3 fromCentre = u + direction * t;
    const V margin = set(s.radius * s.radius) - dot(fromCentre, fromCentre), slope = hn::Abs(fall);
    const M within = margin >= set(0);
    const V blur = set(s.radius) * (set(0x1p-26 * s.radius) + set(0x1p-44) * far);
    const M doubtful = hn::Or(hn::Or(slope <= set(0x1p-40), hn::Abs(margin) * slope <= blur),
                              hn::And(within, hn::Abs(height) <= set(0x1p-44) * far));
    return onceCrossed(t, fall, hn::And(fall != set(0), within), doubtful);
}

HWY_INLINE CrossingLanes crossings(const Plane& s, V3 origin, V3 direction) {
    const V3 normal = spread(s.normal);
    const V fall = hn::Neg(dot(direction, normal));
    const V height = dot(origin, normal) - set(s.distance);
    const V far = sumOfSizes(origin) + set(std::abs(s.distance));
    const M doubtful = hn::Or(hn::Abs(fall) <= set(0x1p-40), hn::Abs(height) <= set(0x1p-44) * far);
    const V t = height / fall;
    // A fall of 0 gives no finite t either.
    return onceCrossed(t, fall, hn::Abs(t) < set(Bounds::infinity), doubtful);
}

} // namespace yarte::trace::HWY_NAMESPACE::YARTE_PRECISION
HWY_AFTER_NAMESPACE();

#endif
