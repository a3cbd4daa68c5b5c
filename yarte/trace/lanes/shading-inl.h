// Shading a packet: surface points, their materials, and local illumination; see yarte/trace/phong.h.
#if defined(YARTE_TRACE_LANES_SHADING_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef YARTE_TRACE_LANES_SHADING_INL_H
#undef YARTE_TRACE_LANES_SHADING_INL_H
#else
#define YARTE_TRACE_LANES_SHADING_INL_H
#endif

#include "yarte/trace/lanes/block_sample.h"
#include "yarte/trace/lanes/normals-inl.h"
#include "yarte/trace/lanes/power-inl.h"
#include "yarte/trace/lanes/shadows-inl.h"
#include "yarte/trace/phong.h"

HWY_BEFORE_NAMESPACE();
namespace yarte::trace::HWY_NAMESPACE::YARTE_PRECISION {

/// Writes the appearance of a body, seen from its front or back, to one lane.
HWY_INLINE void setAppearance(const BodyAppearance& body, bool isBack, std::size_t lane,
                              PointPacket& points) {
    points.ambient.set(lane, body.ambient[isBack]);
    points.diffuse.set(lane, body.diffuse[isBack]);
    points.specular.set(lane, body.specular[isBack]);
    points.exponent[lane] = static_cast<Scalar>(body.exponent);
    points.reflection[lane] = static_cast<Scalar>(body.reflection);
    points.totalReflection[lane] = static_cast<Scalar>(body.totalReflection);
}

/// Calls `visit(lane)` for the first lane of each distinct value that is not `skipped`: few in a coherent
/// packet.
template <class Visit>
HWY_INLINE void forEachDistinct(const Scalar* values, Scalar skipped, Visit&& visit) {
    for (std::size_t lane = 0; lane < lanes; ++lane) {
        bool isSeen = values[lane] == skipped;
        for (std::size_t before = lane; before-- > 0 && !isSeen;) isSeen = values[before] == values[lane];
        if (!isSeen) visit(lane);
    }
}

/// Fills `points` for the lanes that hit something.
HWY_NOINLINE void describeHits(const World& world, const RayPacket& rays, const HitPacket& hits,
                               PointPacket& points) {
    for (std::size_t at = 0; at < lanes; at += half) {
        const V3 p = rays.origin(at) + rays.direction(at) * load(hits.t + at);
        store(p.x, points.px + at), store(p.y, points.py + at), store(p.z, points.pz + at);
    }
    alignas(64) Scalar others[lanes]; // elements whose normals are still to be found
    std::copy_n(hits.element, lanes, others);
    triangleNormals(world, others, points);
    sphereNormals(world, others, points);
    forEachDistinct(others, noElement, [&](std::size_t lane) HWY_ATTR {
        const Scalar element = others[lane];
        world.visit({idIn(element)}, [&]<class Shape>(const Shape& shape) HWY_ATTR {
            if constexpr (!std::is_same_v<Shape, Sphere>)
                for (std::size_t at = 0; at < lanes; at += half) {
                    const M mine = load(others + at) == set(element);
                    if (!any(mine)) continue;
                    const V3 outward = normals(shape, points.position(at), load(hits.part + at));
                    points.setNormal(at, select(mine, outward, points.normal(at)));
                }
        });
    });
    alignas(64) Scalar isBack[lanes];
    for (std::size_t at = 0; at < lanes; at += half) {
        const V3 outward = points.normal(at);
        const M back = dot(rays.direction(at), outward) > set(0);
        points.setNormal(at, select(back, negated(outward), outward));
        store(flag(back), isBack + at);
    }
    for (std::size_t lane = 0; lane < lanes; ++lane)
        if (hits.element[lane] != noElement)
            setAppearance(world.appearanceOf({idIn(hits.element[lane])}), isBack[lane] != 0, lane, points);
}

/// How much of each lane's light arrives, 0 where it is blocked: transmittance of yarte/trace/search.h,
/// multiplied in the same order. For `buffer` and `blocker` see findShadows.
template <bool isTinted>
HWY_NOINLINE void arrivingLight(const World& world, const RayPacket& rays, const LightBuffer& buffer,
                                ShadowPacket& shadow, ElementId& blocker, PassingPacket<isTinted>& arriving) {
    const std::size_t levels = std::min(world.transmissions.size(), ShadowPacket::maxLevels);
    for (std::size_t level = 0; level < levels; ++level)
        for (std::size_t at = 0; at < lanes; at += half) store(set(0), shadow.crossed[level] + at);
    findShadows(world, rays, buffer, shadow, blocker);
    for (std::size_t at = 0; at < lanes; at += half)
        arriving.set(at, passing<isTinted>(set(1) - load(shadow.blocked + at)));
    for (std::size_t level = 0; level < levels; ++level)
        for (std::size_t at = 0; at < lanes; at += half) {
            const auto factor = passing<isTinted>(world.transmissions[level]);
            for (V left = load(shadow.crossed[level] + at); any(left > set(0)); left = left - set(1))
                arriving.set(at, select(left > set(0), arriving.at(at) * factor, arriving.at(at)));
        }
    if (world.transmissions.size() <= ShadowPacket::maxLevels) return;
    for (std::size_t lane = 0; lane < lanes; ++lane)
        if (shadow.blocked[lane] == 0 && shadow.crossed[ShadowPacket::maxLevels - 1][lane] > 0)
            arriving.set(lane, transmittance(world, rays.ray(lane), shadow.distance[lane]));
}

/// localColour of yarte/trace/phong.h for the lanes with a hit; `mirrors` are the mirror directions of the
/// rays; `blockers`, one for each light, see findShadows.
template <bool isTinted>
HWY_NOINLINE void localColours(const World& world, const HitPacket& hits, const PointPacket& points,
                               const RayPacket& mirrors, std::span<ElementId> blockers, ColourPacket& sums,
                               std::uint64_t& shadowRays, std::uint64_t* shadowTicks) {
    const V zero = set(0);
    for (std::size_t at = 0; at < lanes; at += half) sums.set(at, points.ambient.at(at));
    RayPacket toLight;
    ShadowPacket shadow;
    PassingPacket<isTinted> arriving;
    alignas(64) Scalar cosines[lanes];
    for (std::size_t l = 0; l < world.lights.size(); ++l) {
        const Light& light = world.lights[l];
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
        {
            const PhaseTimer timer(shadowTicks);
            arrivingLight<isTinted>(world, toLight, world.lightBuffers[l], shadow, blockers[l], arriving);
        }
        for (std::size_t at = 0; at < lanes; at += half) {
            const Passing<isTinted> light01 = arriving.at(at);
            const M arrives = isLit(light01);
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

} // namespace yarte::trace::HWY_NAMESPACE::YARTE_PRECISION
HWY_AFTER_NAMESPACE();

#endif
