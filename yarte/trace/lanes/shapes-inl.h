// One kernel per shape, for as many rays as the machine has lanes. Each computes what the scalar `crossings`
// in the shape's own header computes, in the same order, so to the last bit; the derivations are there.
#if defined(YARTE_TRACE_LANES_SHAPES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef YARTE_TRACE_LANES_SHAPES_INL_H
#undef YARTE_TRACE_LANES_SHAPES_INL_H
#else
#define YARTE_TRACE_LANES_SHAPES_INL_H
#endif

#include "yarte/trace/box.h"
#include "yarte/trace/cone.h"
#include "yarte/trace/disc.h"
#include "yarte/trace/face.h"
#include "yarte/trace/frustum.h"
#include "yarte/trace/lanes/packet-inl.h"
#include "yarte/trace/plane.h"
#include "yarte/trace/sphere.h"
#include "yarte/trace/truncated_cone.h"

HWY_BEFORE_NAMESPACE();
namespace yarte::trace::HWY_NAMESPACE::YARTE_PRECISION {

HWY_INLINE CrossingLanes noCrossings() { return {set(0), set(0), set(0), set(0), none(), none()}; }

HWY_INLINE CrossingLanes crossings(const Sphere& s, V3 origin, V3 direction) {
    const V radius2 = set(s.radius * s.radius);
    const V3 u = origin - spread(s.centre);
    const V b = hn::Neg(dot(u, direction));
    const V3 nearest = u + direction * b;
    const V discriminant = radius2 - dot(nearest, nearest);
    const M hits = discriminant >= set(0);
    if (!any(hits)) return noCrossings();
    const V h = hn::Sqrt(greatest(discriminant, set(0)));
    const V large = select(b < set(0), b - h, b + h);
    const V small = select(large != set(0), (dot(u, u) - radius2) / large, set(0));
    return {least(large, small), greatest(large, small), set(0), set(0), hits, hits};
}

/// One slab of a box: narrows enter and leave, or rules the lane out.
HWY_INLINE void clipToSlab(V origin, V direction, double halfSide, double lowPart, CrossingLanes& c) {
    const V h = set(halfSide);
    const M parallel = direction == set(0);
    const M outside = hn::And(parallel, hn::Abs(origin) > h);
    const V a = (hn::Neg(h) - origin) / direction, b = (h - origin) / direction;
    const M swapped = a > b;
    const V low = select(swapped, b, a), high = select(swapped, a, b);
    const V lowSide = select(swapped, set(lowPart + 1), set(lowPart));
    const V highSide = select(swapped, set(lowPart), set(lowPart + 1));
    const M later = hn::AndNot(parallel, low > c.enter), earlier = hn::AndNot(parallel, high < c.leave);
    c.enter = select(later, low, c.enter), c.enterPart = select(later, lowSide, c.enterPart);
    c.leave = select(earlier, high, c.leave), c.leavePart = select(earlier, highSide, c.leavePart);
    c.enters = hn::AndNot(outside, c.enters);
}

HWY_INLINE CrossingLanes crossings(const Box& b, V3 worldOrigin, V3 worldDirection) {
    const V3 origin = toLocal(b.axes, worldOrigin - spread(b.centre)),
             direction = toLocal(b.axes, worldDirection);
    CrossingLanes c{set(-Bounds::infinity), set(Bounds::infinity), set(0), set(0),
                    set(0) == set(0),       set(0) == set(0)};
    clipToSlab(origin.x, direction.x, b.half.x, 0, c);
    clipToSlab(origin.y, direction.y, b.half.y, 2, c);
    clipToSlab(origin.z, direction.z, b.half.z, 4, c);
    c.enters = hn::And(c.enters, c.enter <= c.leave);
    c.leaves = c.enters;
    return c;
}

struct StretchLanes {
    V from, to;
};

HWY_INLINE StretchLanes stretchInNappe(V3 p, V3 d, const Nappe& nappe) {
    const V zero = set(0), slope = set(nappe.slope);
    const V moved = hn::Neg(dot(p, d));
    const V3 q = p + d * moved;
    const V x = q.x, z = q.z, r = slope * (set(nappe.height) - q.y) + set(nappe.radius);
    const V dr = slope * hn::Neg(d.y);

    const V a = d.x * d.x + d.z * d.z - dr * dr;
    const V b = x * d.x + z * d.z - r * dr;
    const V c = x * x + z * z - r * r;
    const V xr = x * dr - r * d.x, zr = z * dr - r * d.z, xz = x * d.z - z * d.x;
    const V discriminant = xr * xr + zr * zr - xz * xz;

    const V infinity = set(Bounds::infinity), minusInfinity = set(-Bounds::infinity);
    if (!any(hn::Or(a <= zero, discriminant >= zero))) return {infinity, minusInfinity};

    const V h = hn::Sqrt(greatest(discriminant, zero));
    const V sum = hn::Neg(select(b < zero, b - h, b + h));
    const V root1 = sum / a, root2 = select(sum != zero, c / sum, root1);
    const V low = moved + least(root1, root2), high = moved + greatest(root1, root2);
    const M both = hn::And(a > zero, hn::And(discriminant >= zero, r - b / a * dr > zero));
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
        const M along = hn::And(dr == zero, c <= zero);
        from = select(linear, select(below, single, select(hn::Or(above, along), minusInfinity, infinity)),
                      from);
        to = select(linear, select(hn::Or(below, along), infinity, select(above, single, minusInfinity)), to);
    }
    return {from, to};
}

HWY_INLINE CrossingLanes crossings(const Cone& c, V3 origin, V3 direction) {
    const V zero = set(0), one = set(1);
    const V3 p = toLocal(c.axes, origin - spread(c.centre)), d = toLocal(c.axes, direction);
    auto [from, to] = stretchInNappe(p, d, c.nappe);
    const V base = hn::Neg(p.y) / d.y;
    const M baseEnters = hn::And(d.y > zero, base > from), baseLeaves = hn::And(d.y < zero, base < to);
    from = select(baseEnters, base, from), to = select(baseLeaves, base, to);
    const M beside = hn::And(d.y == zero, p.y < zero);
    const M hits = hn::AndNot(beside, from <= to);
    return {from, to, select(baseEnters, one, zero), select(baseLeaves, one, zero), hits, hits};
}

HWY_INLINE CrossingLanes crossings(const Frustum& f, V3 origin, V3 direction) {
    const V zero = set(0), one = set(1), two = set(2);
    const V3 p = toLocal(f.axes, origin - spread(f.centre)), d = toLocal(f.axes, direction);
    auto [from, to] = stretchInNappe(p, d, f.nappe);
    const V base = hn::Neg(p.y) / d.y, top = (set(f.height) - p.y) / d.y;
    const M upwards = d.y > zero, level = d.y == zero;
    const V enter = select(upwards, base, top), leave = select(upwards, top, base);
    const M later = hn::AndNot(level, enter > from), earlier = hn::AndNot(level, leave < to);
    from = select(later, enter, from), to = select(earlier, leave, to);
    const M beside = hn::And(level, hn::Or(p.y<zero, p.y> set(f.height)));
    const M hits = hn::AndNot(beside, from <= to);
    return {from,
            to,
            select(later, select(upwards, one, two), zero),
            select(earlier, select(upwards, two, one), zero),
            hits,
            hits};
}

HWY_INLINE CrossingLanes crossings(const TruncatedCone& c, V3 origin, V3 direction) {
    const V zero = set(0), height = set(c.height), infinity = set(Bounds::infinity);
    const V3 p = toLocal(c.axes, origin - spread(c.centre)), d = toLocal(c.axes, direction);
    const auto [from, to] = stretchInNappe(p, d, c.nappe);
    const M hits = from <= to;
    const V fromY = p.y + from * d.y, toY = p.y + to * d.y;
    const M keepsFrom = hn::And(hn::Abs(from) < infinity, hn::And(fromY >= zero, fromY <= height));
    const M keepsTo = hn::And(hn::Abs(to) < infinity, hn::And(toY >= zero, toY <= height));
    return {from, to, zero, zero, hn::And(hits, keepsFrom), hn::And(hits, keepsTo)};
}

/// A flat shape is crossed once, one way or the other.
HWY_INLINE CrossingLanes onceCrossed(V t, V fall, M hits) {
    const M enters = fall > set(0);
    return {t, t, set(0), set(0), hn::And(hits, enters), hn::AndNot(enters, hits)};
}

HWY_INLINE CrossingLanes crossings(const Disc& s, V3 origin, V3 direction) {
    const V3 normal = spread(s.normal), u = origin - spread(s.centre);
    const V fall = hn::Neg(dot(direction, normal));
    const V t = dot(u, normal) / fall;
    const V3 fromCentre = u + direction * t;
    return onceCrossed(t, fall,
                       hn::And(fall != set(0), dot(fromCentre, fromCentre) <= set(s.radius * s.radius)));
}

HWY_INLINE CrossingLanes crossings(const Plane& s, V3 origin, V3 direction) {
    const V3 normal = spread(s.normal);
    const V fall = hn::Neg(dot(direction, normal));
    const V t = (dot(origin, normal) - set(s.distance)) / fall;
    // A fall of 0 gives no finite t either.
    return onceCrossed(t, fall, hn::Abs(t) < set(Bounds::infinity));
}

/// Where rounded products do not decide, which is rare, lane by lane with exact ones.
HWY_NOINLINE M exactlyGreater(V ax, V by, V bx, V ay) {
    alignas(64) Scalar a[half], b[half], c[half], d[half], result[half];
    store(ax, a), store(by, b), store(bx, c), store(ay, d);
    for (std::size_t i = 0; i < half; ++i) result[i] = orientation({a[i], d[i]}, {c[i], b[i]}) > 0 ? 1 : 0;
    return isSet(load(result));
}
HWY_NOINLINE M exactlyLess(V ax, V by, V bx, V ay) {
    alignas(64) Scalar a[half], b[half], c[half], d[half], result[half];
    store(ax, a), store(by, b), store(bx, c), store(ay, d);
    for (std::size_t i = 0; i < half; ++i) result[i] = orientation({a[i], d[i]}, {c[i], b[i]}) < 0 ? 1 : 0;
    return isSet(load(result));
}

HWY_INLINE M crossesHalfAxis(V ax, V ay, V bx, V by) {
    const V zero = set(0);
    const M aAbove = ay > zero, bAbove = by > zero;
    const M spans = hn::Xor(aAbove, bAbove);
    const V left = ax * by, right = bx * ay;
    M greater = left > right, less = left < right;
    if (any(hn::And(spans, left == right))) [[unlikely]]
        greater = exactlyGreater(ax, by, bx, ay), less = exactlyLess(ax, by, bx, ay);
    return hn::And(spans, hn::Or(hn::And(bAbove, greater), hn::AndNot(bAbove, less)));
}

/// Lanes whose ray passes inside the polygon: even-odd.
HWY_INLINE M seesThrough(std::span<const std::uint32_t> corners, const Vec3* vertices, const V3& origin,
                         const ShearPacket& shear, std::size_t at) {
    V ax, ay, bx, by;
    if (corners.size() == 3) { // the usual case, unrolled
        V cx, cy;
        shear.see(origin, at, vertices[corners[0]], ax, ay);
        shear.see(origin, at, vertices[corners[1]], bx, by);
        shear.see(origin, at, vertices[corners[2]], cx, cy);
        return hn::Xor(crossesHalfAxis(ax, ay, bx, by),
                       hn::Xor(crossesHalfAxis(bx, by, cx, cy), crossesHalfAxis(cx, cy, ax, ay)));
    }
    M inside = none();
    shear.see(origin, at, vertices[corners.back()], ax, ay);
    for (const std::uint32_t vertex : corners) {
        shear.see(origin, at, vertices[vertex], bx, by);
        inside = hn::Xor(inside, crossesHalfAxis(ax, ay, bx, by));
        ax = bx, ay = by;
    }
    return inside;
}

/// How far the origins are in front of a face's plane. In float the camera is at the origin, and from there
/// the plane is known better than by a corner that may be far away.
HWY_INLINE V heightAbove(const FacePlane& plane, V3 origin) {
    const V3 normal = spread(plane.normal);
    if constexpr (isFloat) return dot(origin, normal) - set(dot(plane.anchor, plane.normal));
    return dot(origin - spread(plane.anchor), normal);
}

/// A triangle as a tree's leaf knows it.
struct TriangleShape {
    static constexpr bool isFlat = true, isClosed = false;
    const Vec3* vertices;
    const std::uint32_t* corners;
};

HWY_INLINE CrossingLanes crossings(const TriangleShape& s, const RayPacket& rays, const ShearPacket& shear,
                                   std::size_t at, V rounding) {
    const V3 origin = rays.origin(at), direction = rays.direction(at);
    const M inside = seesThrough(std::span(s.corners, 3), s.vertices, origin, shear, at);
    if (!any(inside)) return noCrossings();
    const Vec3 anchor = s.vertices[s.corners[0]];
    const FacePlane plane{triangleNormal(anchor, s.vertices[s.corners[1]], s.vertices[s.corners[2]]), anchor};
    const V fall = hn::Neg(dot(direction, spread(plane.normal)));
    const V height = heightAbove(plane, origin);
    const M isOff = hn::Abs(height) > rounding;
    return onceCrossed(height / fall, fall, hn::And(hn::And(inside, isOff), fall != set(0)));
}

/// Crossings beyond `limit` may be left out.
HWY_INLINE CrossingLanes crossings(const FaceShape& s, const RayPacket& rays, const ShearPacket& shear,
                                   std::size_t at, V rounding, V limit) {
    const V3 origin = rays.origin(at), direction = rays.direction(at);
    V fall = set(0), t = set(0);
    M isOff = none();
    const auto meetPlane = [&](const FacePlane& plane) HWY_ATTR {
        fall = hn::Neg(dot(direction, spread(plane.normal)));
        const V height = heightAbove(plane, origin);
        isOff = hn::Abs(height) > rounding;
        t = height / fall;
    };
    const bool isKnown = s.face.plane != Face::noPlane;
    if (isKnown) { // a look at the plane spares most looks at the edges
        meetPlane(s.table.planes[s.face.plane]);
        if (!any(hn::And(t > set(0), t <= limit))) return noCrossings();
    }
    const M inside = seesThrough(s.table.cornersOf(s.face), s.table.vertices.data(), origin, shear, at);
    if (!any(inside)) return noCrossings();
    if (!isKnown) meetPlane(computePlane(s.table, s.face));
    return onceCrossed(t, fall, hn::And(hn::And(inside, isOff), fall != set(0)));
}

} // namespace yarte::trace::HWY_NAMESPACE::YARTE_PRECISION
HWY_AFTER_NAMESPACE();

#endif
