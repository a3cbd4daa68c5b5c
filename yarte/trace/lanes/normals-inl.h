// Outward normals, lane by lane the bits of each shape's `outwardNormal`.
#if defined(YARTE_TRACE_LANES_NORMALS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef YARTE_TRACE_LANES_NORMALS_INL_H
#undef YARTE_TRACE_LANES_NORMALS_INL_H
#else
#define YARTE_TRACE_LANES_NORMALS_INL_H
#endif

#include "yarte/trace/lanes/points-inl.h"
#include "yarte/trace/world.h"

HWY_BEFORE_NAMESPACE();
namespace yarte::trace::HWY_NAMESPACE::YARTE_PRECISION {

HWY_INLINE V3 normals(const Box& b, V3, V part) {
    const V3 axis =
        select(part < set(2), spread(b.axes.x), select(part < set(4), spread(b.axes.y), spread(b.axes.z)));
    const M low = hn::Or(part == set(0), hn::Or(part == set(2), part == set(4)));
    return select(low, negated(axis), axis);
}
HWY_INLINE V3 nappeNormals(V3 p, const Nappe& nappe) {
    const V distance = hn::Sqrt(p.x * p.x + p.z * p.z);
    const V3 normal = normalised(V3{p.x / distance, set(nappe.slope), p.z / distance});
    return select(distance == set(0), V3{set(0), set(1), set(0)}, normal);
}
HWY_INLINE V3 normals(const Cone& c, V3 point, V part) {
    const V3 lateral = toWorld(c.axes, nappeNormals(toLocal(c.axes, point - spread(c.centre)), c.nappe));
    return select(part == set(1), negated(spread(c.axes.y)), lateral);
}
HWY_INLINE V3 normals(const TruncatedCone& c, V3 point, V) {
    return toWorld(c.axes, nappeNormals(toLocal(c.axes, point - spread(c.centre)), c.nappe));
}
HWY_INLINE V3 normals(const Frustum& f, V3 point, V part) {
    const V3 lateral = toWorld(f.axes, nappeNormals(toLocal(f.axes, point - spread(f.centre)), f.nappe));
    const V3 axis = spread(f.axes.y);
    return select(part == set(0), lateral, select(part == set(1), negated(axis), axis));
}
HWY_INLINE V3 normals(const Disc& d, V3, V) { return spread(d.normal); }
HWY_INLINE V3 normals(const Plane& p, V3, V) { return spread(p.normal); }
/// Of a polygon; triangles have triangleNormals.
HWY_INLINE V3 normals(const FaceShape& s, V3, V) { return spread(planeOf(s.table, s.face).normal); }

/// Corners (or edges, or vertex normals) of the triangles that the lanes hit.
struct alignas(64) CornerPacket {
    Scalar x[3][lanes], y[3][lanes], z[3][lanes];
    HWY_INLINE void put(std::size_t corner, std::size_t lane, Vec3 v) {
        x[corner][lane] = static_cast<Scalar>(v.x), y[corner][lane] = static_cast<Scalar>(v.y);
        z[corner][lane] = static_cast<Scalar>(v.z);
    }
    HWY_INLINE V3 at(std::size_t corner, std::size_t i) const {
        return {load(x[corner] + i), load(y[corner] + i), load(z[corner] + i)};
    }
};

/// The two coordinates that remain when the largest component of a normal is left out; see outwardNormal in
/// face.cpp.
struct Flattener {
    M isX, isY;
    explicit HWY_INLINE Flattener(V3 n) {
        const V ax = hn::Abs(n.x), ay = hn::Abs(n.y), az = hn::Abs(n.z);
        isX = hn::And(ax >= ay, ax >= az), isY = hn::AndNot(isX, ay >= az);
    }
    HWY_INLINE V u(V3 v) const { return select(isX, v.y, select(isY, v.z, v.x)); }
    HWY_INLINE V v(V3 p) const { return select(isX, p.z, select(isY, p.x, p.y)); }
};

HWY_INLINE V doubleArea(const Flattener& flat, V3 a, V3 b, V3 c) {
    return (flat.u(b) - flat.u(a)) * (flat.v(c) - flat.v(a)) -
           (flat.u(c) - flat.u(a)) * (flat.v(b) - flat.v(a));
}

HWY_INLINE V3 interpolatedNormals(V3 a, V3 b, V3 c, V3 p, V3 normalA, V3 normalB, V3 normalC, V3 flatNormal) {
    const V zero = set(0);
    const Flattener flat(flatNormal);
    const V3 sum = normalA * doubleArea(flat, p, b, c) + normalB * doubleArea(flat, a, p, c) +
                   normalC * doubleArea(flat, a, b, p);
    const V3 interpolated = select(doubleArea(flat, a, b, c) < zero, negated(sum), sum);
    const M vanishes =
        hn::And(interpolated.x == zero, hn::And(interpolated.y == zero, interpolated.z == zero));
    return select(vanishes, flatNormal, normalised(interpolated));
}

HWY_INLINE void interpolateNormals(const FaceTable& table, const Face* const* faces, PointPacket& points) {
    CornerPacket corners{}, normals{};
    alignas(64) Scalar isSmooth[lanes] = {};
    for (std::size_t lane = 0; lane < lanes; ++lane) {
        if (!faces[lane] || !faces[lane]->isSmooth) continue;
        isSmooth[lane] = 1;
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const std::size_t at = faces[lane]->firstCorner + corner;
            corners.put(corner, lane, table.vertices[table.corners[at]]);
            normals.put(corner, lane, table.normals[table.cornerNormals[at]]);
        }
    }
    for (std::size_t at = 0; at < lanes; at += half) {
        const V3 flat = points.normal(at);
        const V3 smooth =
            interpolatedNormals(corners.at(0, at), corners.at(1, at), corners.at(2, at), points.position(at),
                                normals.at(0, at), normals.at(1, at), normals.at(2, at), flat);
        points.setNormal(at, select(isSet(load(isSmooth + at)), smooth, flat));
    }
}

/// Triangles all at once, since neighbouring rays often hit different ones of the same mesh: writes their
/// normals to `points`, and noElement to `elements` in the lanes done.
HWY_INLINE void triangleNormals(const World& world, Scalar* elements, PointPacket& points) {
    const FaceTable& table = world.faces;
    const Face* faces[lanes] = {};
    bool someTriangle = false, someSmooth = false;
    for (std::size_t lane = 0; lane < lanes; ++lane) {
        if (elements[lane] == noElement) continue;
        const auto [kind, row] = world.elements[idIn(elements[lane])];
        if (kind != Kind::face || table.faces[row].cornerCount != 3) continue;
        faces[lane] = &table.faces[row];
        elements[lane] = noElement;
        someTriangle = true, someSmooth = someSmooth || faces[lane]->isSmooth;
    }
    if (!someTriangle) return;
    CornerPacket edges{};
    for (std::size_t lane = 0; lane < lanes; ++lane) {
        if (!faces[lane]) continue;
        const auto corners = table.cornersOf(*faces[lane]);
        const Vec3 a = table.vertices[corners[0]];
        // Before they are rounded to float, which may leave little of a small triangle far away.
        edges.put(0, lane, table.vertices[corners[1]] - a),
            edges.put(1, lane, table.vertices[corners[2]] - a);
    }
    for (std::size_t at = 0; at < lanes; at += half) {
        const V3 ab = edges.at(0, at), ac = edges.at(1, at);
        const V3 plain{ab.y * ac.z - ab.z * ac.y, ab.z * ac.x - ab.x * ac.z, ab.x * ac.y - ab.y * ac.x};
        // The other lanes, 0/0 for now, are written later.
        points.setNormal(at, normalised(plain));
        const M sliver = dot(plain, plain) < set(maxSliver) * (dot(ab, ab) * dot(ac, ac));
        for (std::uint32_t bits = bitsOf(D(), sliver); bits != 0; bits &= bits - 1) {
            const std::size_t lane = at + static_cast<std::size_t>(std::countr_zero(bits));
            const Vec3 n = planeOf(table, *faces[lane]).normal;
            points.nx[lane] = static_cast<Scalar>(n.x), points.ny[lane] = static_cast<Scalar>(n.y),
            points.nz[lane] = static_cast<Scalar>(n.z);
        }
    }
    if (someSmooth) interpolateNormals(table, faces, points);
}

/// The same for spheres: rays that were reflected by small ones go apart and meet as many.
HWY_INLINE void sphereNormals(const World& world, Scalar* elements, PointPacket& points) {
    alignas(64) Scalar x[lanes] = {}, y[lanes] = {}, z[lanes] = {}, isSphere[lanes] = {};
    bool someSphere = false;
    for (std::size_t lane = 0; lane < lanes; ++lane) {
        if (elements[lane] == noElement) continue;
        const auto [kind, row] = world.elements[idIn(elements[lane])];
        if (kind != Kind::sphere) continue;
        const Vec3 centre = world.spheres[row].centre;
        x[lane] = static_cast<Scalar>(centre.x), y[lane] = static_cast<Scalar>(centre.y);
        z[lane] = static_cast<Scalar>(centre.z);
        isSphere[lane] = 1, elements[lane] = noElement;
        someSphere = true;
    }
    if (!someSphere) return;
    for (std::size_t at = 0; at < lanes; at += half) {
        const V3 outward = normalised(points.position(at) - V3{load(x + at), load(y + at), load(z + at)});
        points.setNormal(at, select(isSet(load(isSphere + at)), outward, points.normal(at)));
    }
}

} // namespace yarte::trace::HWY_NAMESPACE::YARTE_PRECISION
HWY_AFTER_NAMESPACE();

#endif
