// The kernels of faces, as those of the other shapes in shapes-inl.h: what `quickCrossings` in
// yarte/trace/face.h computes, to the last bit; the derivations are there.
#if defined(YARTE_TRACE_LANES_FACES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef YARTE_TRACE_LANES_FACES_INL_H
#undef YARTE_TRACE_LANES_FACES_INL_H
#else
#define YARTE_TRACE_LANES_FACES_INL_H
#endif

#include "yarte/trace/face.h"
#include "yarte/trace/lanes/shapes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace yarte::trace::HWY_NAMESPACE::YARTE_PRECISION {

/// Which lanes pass inside a face, as far as rounding tells.
struct SightLanes {
    M inside, doubtful;
};

/// As EdgeCount.
class EdgeLanes {
public:
    HWY_INLINE EdgeLanes()
        : inside_(none()), nearest_(set(Bounds::infinity)), across_(set(0)), depth_(set(0)) {}

    HWY_INLINE void add(V3 a, V3 b) {
        const V zero = set(0), determinant = a.x * b.y - b.x * a.y;
        const M aAbove = a.y > zero, bAbove = b.y > zero;
        const M crosses = hn::Or(hn::And(bAbove, determinant > zero), hn::AndNot(bAbove, determinant < zero));
        inside_ = hn::Xor(inside_, hn::And(hn::Xor(aAbove, bAbove), crosses));
        nearest_ = hn::Min(nearest_, hn::Abs(determinant));
        across_ = hn::Max(across_, hn::Max(hn::Abs(b.x), hn::Abs(b.y)));
        depth_ = hn::Max(depth_, hn::Abs(b.z));
    }
    HWY_INLINE SightLanes sight() const {
        return {inside_, nearest_ <= set(edgeBlur) * across_ * hn::Max(across_, depth_)};
    }

private:
    M inside_;
    V nearest_, across_, depth_;
};

HWY_INLINE SightLanes lookThrough(std::span<const std::uint32_t> corners, const Vec3* vertices,
                                  const V3& origin, const ShearPacket& shear, std::size_t at) {
    EdgeLanes edges;
    V3 previous = shear.see(origin, at, vertices[corners.back()]);
    for (const std::uint32_t vertex : corners) {
        const V3 next = shear.see(origin, at, vertices[vertex]);
        edges.add(previous, next);
        previous = next;
    }
    return edges.sight();
}

/// Inside a triangle the three determinants have one sign. In float, where nobody decides what is in doubt,
/// it is the count of edges that leaks nowhere.
HWY_INLINE SightLanes lookThroughTriangle(const std::uint32_t* corners, const Vec3* vertices,
                                          const V3& origin, const ShearPacket& shear, std::size_t at) {
    const V3 a = shear.see(origin, at, vertices[corners[0]]), b = shear.see(origin, at, vertices[corners[1]]),
             c = shear.see(origin, at, vertices[corners[2]]);
    const auto countEdges = [&]() HWY_ATTR {
        EdgeLanes edges;
        edges.add(c, a), edges.add(a, b), edges.add(b, c);
        return edges.sight();
    };
    if constexpr (isFloat) return countEdges();
    const V ab = a.x * b.y - b.x * a.y, bc = b.x * c.y - c.x * b.y, ca = c.x * a.y - a.x * c.y;
    const V nearest = hn::Min(hn::Min(hn::Abs(ab), hn::Abs(bc)), hn::Abs(ca));
    if (any(nearest <= load(shear.blur + at))) [[unlikely]]
        return countEdges();
    const M inside = hn::Or(hn::Min(hn::Min(ab, bc), ca) > set(0), hn::Max(hn::Max(ab, bc), ca) < set(0));
    return {inside, none()};
}

/// Where lines meet the plane of a face.
struct PlaneLanes {
    V fall, t;
    M meets, doubtful;

    HWY_INLINE PlaneLanes(const RayPacket& rays, std::size_t at, const FacePlane& plane, V rounding) {
        const V3 normal = spread(plane.normal), origin = rays.origin(at),
                 fromAnchor = origin - spread(plane.anchor);
        fall = hn::Neg(dot(rays.direction(at), normal));
        // In float the camera is at the origin, and from there the plane is known better than by a corner
        // that may be far away.
        const V height =
            isFloat ? dot(origin, normal) - set(dot(plane.anchor, plane.normal)) : dot(fromAnchor, normal);
        meets = hn::Or(load(rays.from + at) == set(noElement), hn::Abs(height) > rounding);
        doubtful = hn::And(meets, hn::Or(hn::Abs(fall) <= set(0x1p-20),
                                         hn::Abs(height) <= set(0x1p-16) * sumOfSizes(fromAnchor)));
        meets = hn::And(meets, fall != set(0));
        t = height / fall;
    }
};

HWY_INLINE CrossingLanes crossings(const SightLanes& sight, const PlaneLanes& plane) {
    return onceCrossed(plane.t, plane.fall, hn::And(sight.inside, plane.meets),
                       hn::Or(sight.doubtful, hn::And(sight.inside, plane.doubtful)));
}

/// A triangle as a tree's leaf knows it.
struct TriangleShape {
    static constexpr bool isFlat = true, isClosed = false;
    const Vec3* vertices;
    const std::uint32_t* corners;
    double rounding; ///< of FaceTable
};

inline Crossings carefulCrossings(const TriangleShape& s, const Ray& ray) {
    return trace::carefulCrossings(std::span(s.corners, 3), s.vertices, s.rounding, ray);
}

HWY_INLINE CrossingLanes crossings(const TriangleShape& s, const RayPacket& rays, const ShearPacket& shear,
                                   std::size_t at, V rounding) {
    const SightLanes sight = lookThroughTriangle(s.corners, s.vertices, rays.origin(at), shear, at);
    if (!any(possible(sight.inside, sight.doubtful))) return noCrossings();
    const Vec3 anchor = s.vertices[s.corners[0]];
    const FacePlane plane{triangleNormal(anchor, s.vertices[s.corners[1]], s.vertices[s.corners[2]]), anchor};
    return crossings(sight, PlaneLanes(rays, at, plane, rounding));
}

/// Crossings beyond `limit` may be left out.
HWY_INLINE CrossingLanes crossings(const FaceShape& s, const RayPacket& rays, const ShearPacket& shear,
                                   std::size_t at, V rounding, V limit) {
    const auto corners = s.table.cornersOf(s.face);
    const Vec3* const vertices = s.table.vertices.data();
    if (s.face.plane == Face::noPlane)
        return crossings(TriangleShape{vertices, corners.data(), s.table.rounding}, rays, shear, at,
                         rounding);
    // A look at the plane spares most looks at the edges.
    const PlaneLanes plane(rays, at, s.table.planes[s.face.plane], rounding);
    if (!any(possible(hn::And(plane.t > set(0), plane.t <= limit), plane.doubtful))) return noCrossings();
    return crossings(lookThrough(corners, vertices, rays.origin(at), shear, at), plane);
}

} // namespace yarte::trace::HWY_NAMESPACE::YARTE_PRECISION
HWY_AFTER_NAMESPACE();

#endif
