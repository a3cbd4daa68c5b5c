// Shading a packet: surface points, their materials, and local illumination; see yarte/trace/phong.h.
#if defined(YARTE_TRACE_LANES_SHADING_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef YARTE_TRACE_LANES_SHADING_INL_H
#undef YARTE_TRACE_LANES_SHADING_INL_H
#else
#define YARTE_TRACE_LANES_SHADING_INL_H
#endif

#include "yarte/trace/lanes/power-inl.h"
#include "yarte/trace/lanes/search-inl.h"
#include "yarte/trace/phong.h"

HWY_BEFORE_NAMESPACE();
namespace yarte::trace::HWY_NAMESPACE {

struct C3 {
    V r, g, b;
};
HWY_INLINE C3 operator+(C3 a, C3 b) { return {a.r + b.r, a.g + b.g, a.b + b.b}; }
HWY_INLINE C3 operator*(C3 a, C3 b) { return {a.r * b.r, a.g * b.g, a.b * b.b}; }
HWY_INLINE C3 operator*(C3 a, V s) { return {a.r * s, a.g * s, a.b * s}; }
HWY_INLINE C3 spread(Colour c) { return {set(c.r), set(c.g), set(c.b)}; }
HWY_INLINE C3 select(M mask, C3 yes, C3 no) {
    return {select(mask, yes.r, no.r), select(mask, yes.g, no.g), select(mask, yes.b, no.b)};
}
HWY_INLINE M isLit(C3 c) {
    const V zero = set(0);
    return hn::Or(c.r != zero, hn::Or(c.g != zero, c.b != zero));
}

struct alignas(64) ColourPacket {
    double r[lanes], g[lanes], b[lanes];
    HWY_INLINE C3 at(std::size_t i) const { return {load(r + i), load(g + i), load(b + i)}; }
    HWY_INLINE void set(std::size_t i, C3 c) { store(c.r, r + i), store(c.g, g + i), store(c.b, b + i); }
};

/// Surface points and their materials, lane by lane. Lanes without a hit hold zeros.
struct alignas(64) PointPacket {
    double px[lanes], py[lanes], pz[lanes]; ///< position
    double nx[lanes], ny[lanes], nz[lanes]; ///< unit normal, turned to face the viewer
    double exponent[lanes], reflection[lanes], transmission[lanes];
    ColourPacket ambient, diffuse, specular;

    HWY_INLINE V3 position(std::size_t i) const { return {load(px + i), load(py + i), load(pz + i)}; }
    HWY_INLINE V3 normal(std::size_t i) const { return {load(nx + i), load(ny + i), load(nz + i)}; }
};

HWY_INLINE V3 normals(const Sphere& s, V3 point, V) { return normalised(point - spread(s.centre)); }
HWY_INLINE V3 normals(const Box& b, V3, V part) {
    const V3 axis =
        select(part < set(2), spread(b.axes.x), select(part < set(4), spread(b.axes.y), spread(b.axes.z)));
    const M low = hn::Or(part == set(0), hn::Or(part == set(2), part == set(4)));
    return select(low, negated(axis), axis);
}
HWY_INLINE V3 nappeNormals(V3 p, double slope) {
    const V distance = hn::Sqrt(p.x * p.x + p.z * p.z);
    const V3 normal = normalised(V3{p.x / distance, set(slope), p.z / distance});
    return select(distance == set(0), V3{set(0), set(1), set(0)}, normal);
}
HWY_INLINE V3 normals(const Cone& c, V3 point, V part) {
    const V3 lateral = toWorld(c.axes, nappeNormals(toLocal(c.axes, point - spread(c.centre)), c.slope));
    return select(part == set(1), negated(spread(c.axes.y)), lateral);
}
HWY_INLINE V3 normals(const TruncatedCone& c, V3 point, V) {
    return toWorld(c.axes, nappeNormals(toLocal(c.axes, point - spread(c.centre)), c.slope));
}
HWY_INLINE V3 normals(const Disc& d, V3, V) { return spread(d.normal); }
HWY_INLINE V3 normals(const FaceShape& s, V3 point, V) {
    if (!s.face.isSmooth) return spread(planeOf(s.table, s.face).normal);
    alignas(64) double x[half], y[half], z[half];
    store(point.x, x), store(point.y, y), store(point.z, z);
    for (std::size_t i = 0; i < half; ++i) {
        const Vec3 n = outwardNormal(s, {x[i], y[i], z[i]}, 0);
        x[i] = n.x, y[i] = n.y, z[i] = n.z;
    }
    return {load(x), load(y), load(z)};
}

/// Blends the element's normal and material into the lanes that hit it.
template <class Shape>
HWY_INLINE void describe(const Shape& shape, double element, const BodyAppearance& body,
                         const RayPacket& rays, const HitPacket& hits, PointPacket& points) {
    for (std::size_t at = 0; at < lanes; at += half) {
        const M mine = load(hits.element + at) == set(element);
        if (!any(mine)) continue;
        const V3 outward = normals(shape, points.position(at), load(hits.part + at));
        const M isBack = dot(rays.direction(at), outward) > set(0);
        const V3 normal = select(mine, select(isBack, negated(outward), outward), points.normal(at));
        store(normal.x, points.nx + at), store(normal.y, points.ny + at), store(normal.z, points.nz + at);
        const auto blend = [&](ColourPacket& to, const Colour* sides) HWY_ATTR {
            to.set(at, select(mine, select(isBack, spread(sides[1]), spread(sides[0])), to.at(at)));
        };
        blend(points.ambient, body.ambient), blend(points.diffuse, body.diffuse),
            blend(points.specular, body.specular);
        store(select(mine, set(body.exponent), load(points.exponent + at)), points.exponent + at);
        store(select(mine, set(body.reflection), load(points.reflection + at)), points.reflection + at);
        store(select(mine, set(body.transmission), load(points.transmission + at)), points.transmission + at);
    }
}

/// Fills `points` for the lanes that hit something: once per distinct element, which are few in a coherent
/// packet.
HWY_NOINLINE void describeHits(const World& world, const RayPacket& rays, const HitPacket& hits,
                               PointPacket& points) {
    for (std::size_t at = 0; at < lanes; at += half) {
        const V t = load(hits.t + at);
        const V3 p = rays.origin(at) + rays.direction(at) * t;
        store(p.x, points.px + at), store(p.y, points.py + at), store(p.z, points.pz + at);
    }
    for (std::size_t lane = 0; lane < lanes; ++lane) {
        const double element = hits.element[lane];
        bool isSeen = element == noElement;
        for (std::size_t before = 0; before < lane && !isSeen; ++before)
            isSeen = hits.element[before] == element;
        if (isSeen) continue;
        const ElementId id{static_cast<std::uint32_t>(element)};
        world.visit(id, [&](const auto& shape) HWY_ATTR {
            describe(shape, element, world.appearanceOf(id), rays, hits, points);
        });
    }
}

/// How much of each lane's light arrives, 0 where it is blocked: transmittance of yarte/trace/search.h,
/// multiplied in the same order.
HWY_NOINLINE void arrivingLight(const World& world, const RayPacket& rays, ShadowPacket& shadow,
                                double* arriving) {
    const std::size_t levels = std::min(world.transmissions.size(), ShadowPacket::maxLevels);
    for (std::size_t level = 0; level < levels; ++level)
        for (std::size_t at = 0; at < lanes; at += half) store(set(0), shadow.crossed[level] + at);
    findShadows(world, rays, shadow);
    for (std::size_t at = 0; at < lanes; at += half) store(set(1) - load(shadow.blocked + at), arriving + at);
    for (std::size_t level = 0; level < levels; ++level)
        for (std::size_t at = 0; at < lanes; at += half) {
            const V factor = set(world.transmissions[level]);
            for (V left = load(shadow.crossed[level] + at); any(left > set(0)); left = left - set(1))
                store(select(left > set(0), load(arriving + at) * factor, load(arriving + at)),
                      arriving + at);
        }
    if (world.transmissions.size() <= ShadowPacket::maxLevels) return;
    for (std::size_t lane = 0; lane < lanes; ++lane)
        if (shadow.blocked[lane] == 0 && shadow.crossed[ShadowPacket::maxLevels - 1][lane] > 0)
            arriving[lane] = transmittance(world, rays.ray(lane), shadow.distance[lane]);
}

/// localColour of yarte/trace/phong.h for the lanes with a hit; `mirrors` are the mirror directions of the
/// rays.
HWY_NOINLINE void localColours(const World& world, const HitPacket& hits, const PointPacket& points,
                               const RayPacket& mirrors, ColourPacket& sums, std::uint64_t& shadowRays) {
    const V zero = set(0);
    for (std::size_t at = 0; at < lanes; at += half) sums.set(at, points.ambient.at(at));
    RayPacket toLight;
    ShadowPacket shadow;
    alignas(64) double cosines[lanes], arriving[lanes];
    for (const Light& light : world.lights) {
        bool someLit = false;
        for (std::size_t at = 0; at < lanes; at += half) {
            const V3 position = points.position(at), way = spread(light.position) - position;
            const V distance = hn::Sqrt(dot(way, way));
            const V3 direction = way / distance;
            const V cosine = dot(points.normal(at), direction);
            const M shines = hn::Or(isLit(points.diffuse.at(at)), isLit(points.specular.at(at)));
            const M lit = hn::And(hn::And(load(hits.element + at) != set(noElement), shines), cosine > zero);
            toLight.setOrigin(at, position), toLight.setDirection(at, direction);
            store(load(hits.element + at), toLight.from + at);
            store(flag(load(hits.entering + at) == zero), toLight.inside + at);
            store(distance, shadow.distance + at);
            store(flag(hn::Not(lit)), shadow.blocked + at);
            store(cosine, cosines + at);
            someLit = someLit || any(lit);
            shadowRays += hn::CountTrue(D(), lit);
        }
        if (!someLit) continue;
        arrivingLight(world, toLight, shadow, arriving);
        for (std::size_t at = 0; at < lanes; at += half) {
            const V light01 = load(arriving + at);
            const M arrives = light01 != zero;
            if (!any(arrives)) continue;
            const V highlight = dot(mirrors.direction(at), toLight.direction(at));
            C3 reflected = points.diffuse.at(at) * load(cosines + at);
            const M shines = hn::And(arrives, highlight > zero);
            if (any(shines)) {
                const V shine = power(select(shines, highlight, set(1)), load(points.exponent + at));
                reflected = select(shines, reflected + points.specular.at(at) * shine, reflected);
            }
            const C3 sum = sums.at(at);
            sums.set(at, select(arrives, sum + spread(light.brightness) * light01 * reflected, sum));
        }
    }
}

} // namespace yarte::trace::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
