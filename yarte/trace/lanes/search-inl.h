// Searching the world along a packet of rays; see yarte/trace/search.h for what is found.
#if defined(YARTE_TRACE_LANES_SEARCH_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef YARTE_TRACE_LANES_SEARCH_INL_H
#undef YARTE_TRACE_LANES_SEARCH_INL_H
#else
#define YARTE_TRACE_LANES_SEARCH_INL_H
#endif

#include "yarte/trace/lanes/faces-inl.h"
#include "yarte/trace/lanes/tree-inl.h"
#include "yarte/trace/search.h"
#include "yarte/trace/world.h"

HWY_BEFORE_NAMESPACE();
namespace yarte::trace::HWY_NAMESPACE::YARTE_PRECISION {

/// A packet as all kernels see it: what only some shapes need is computed once.
struct Lines {
    const RayPacket& rays;
    const ShearPacket& shear;
    const RoundingPacket& rounding;
};

template <class Shape>
HWY_INLINE CrossingLanes crossings(const Shape& shape, const Lines& lines, std::size_t at, V limit) {
    if constexpr (std::is_same_v<Shape, TriangleShape>)
        return crossings(shape, lines.rays, lines.shear, at, lines.rounding.at(at));
    else if constexpr (std::is_same_v<Shape, FaceShape>)
        return crossings(shape, lines.rays, lines.shear, at, lines.rounding.at(at), limit);
    else
        return crossings(shape, lines.rays.origin(at), lines.rays.direction(at));
}

/// Lanes that start on the element itself: they meet it only from its inside, and only at its far end.
struct Departing {
    M any, inside;
};

HWY_INLINE Departing departing(const RayPacket& rays, std::size_t at, Scalar element) {
    const M departs = load(rays.from + at) == set(element);
    return {departs, hn::And(departs, isSet(load(rays.inside + at)))};
}

/// The crossings, those of the lanes in doubt computed again, one by one with care. By value: the caller's
/// stay in registers.
template <class Shape>
HWY_NOINLINE CrossingLanes settled(const Shape& shape, const RayPacket& rays, std::size_t at, M doubtful,
                                   CrossingLanes c) {
    alignas(64) Scalar enter[half], leave[half], enterPart[half], leavePart[half], enters[half], leaves[half];
    store(c.enter, enter), store(c.leave, leave), store(c.enterPart, enterPart),
        store(c.leavePart, leavePart);
    store(flag(c.enters), enters), store(flag(c.leaves), leaves);
    for (std::uint32_t bits = bitsOf(D(), doubtful); bits != 0; bits &= bits - 1) {
        const auto lane = static_cast<std::size_t>(std::countr_zero(bits));
        enters[lane] = leaves[lane] = 0;
        for (const Crossing& crossing : carefulCrossings(shape, rays.ray(at + lane))) {
            (crossing.entering ? enters : leaves)[lane] = 1;
            (crossing.entering ? enter : leave)[lane] = crossing.t;
            (crossing.entering ? enterPart : leavePart)[lane] = crossing.part;
        }
    }
    return {load(enter),         load(leave),         load(enterPart), load(leavePart),
            isSet(load(enters)), isSet(load(leaves)), none()};
}

/// The crossings that count: ahead of the start, and not the start itself. Those beyond `limit` may be left
/// out.
template <class Shape>
HWY_INLINE CrossingLanes ahead(const Shape& shape, const Lines& lines, std::size_t at, Scalar element,
                               V limit) {
    const V zero = set(0);
    // A start on one surface may in float be on the wrong side of another that touches it there.
    const V start = isFloat ? lines.rounding.at(at) : zero;
    CrossingLanes c = crossings(shape, lines, at, limit);
    const Departing departs = departing(lines.rays, at, element);
    if (!any(isFloat ? departs.any : hn::Or(departs.any, c.doubtful))) {
        c.enters = hn::And(c.enters, c.enter > start), c.leaves = hn::And(c.leaves, c.leave > start);
        return c;
    }
    if constexpr (!isFloat) { // lanes whose search has ended have no reach
        const M doubtful = hn::And(hn::AndNot(departs.any, c.doubtful), limit > zero);
        if (any(doubtful)) [[unlikely]]
            c = settled(shape, lines.rays, at, doubtful, c);
    }
    const M leaves = c.leaves;
    c.enters = hn::AndNot(departs.any, hn::And(c.enters, c.enter > start));
    c.leaves = hn::And(leaves, c.leave > start);
    if constexpr (Shape::isFlat) {
        c.leaves = hn::AndNot(departs.any, c.leaves);
    } else {
        c.leaves = hn::AndNot(hn::AndNot(departs.inside, departs.any), c.leaves);
        if constexpr (Shape::isClosed) { // left in any case, however close rounding puts the end to the start
            c.leave = select(departs.inside, select(leaves, greatest(c.leave, zero), zero), c.leave);
            c.leavePart = select(hn::AndNot(leaves, departs.inside), zero, c.leavePart);
            c.leaves = hn::Or(c.leaves, departs.inside);
        }
    }
    return c;
}

template <class Shape>
HWY_INLINE bool improve(const Shape& shape, Scalar element, const Lines& lines, std::uint32_t mask,
                        HitPacket& best) {
    bool improved = false;
    for (std::size_t at = 0; at < lanes; at += half) {
        if (bitsIn(mask, at) == 0) continue;
        const CrossingLanes c = ahead(shape, lines, at, element, load(best.t + at));
        const M some = hn::Or(c.enters, c.leaves);
        if (!any(some)) continue;
        const V t = select(c.enters, c.enter, c.leave);
        const V bestT = load(best.t + at);
        const M first = hn::And(t == bestT, set(element) < load(best.element + at));
        const M better = hn::And(some, hn::Or(t < bestT, first));
        if (!any(better)) continue;
        improved = true;
        store(select(better, t, bestT), best.t + at);
        store(select(better, set(element), load(best.element + at)), best.element + at);
        store(select(better, select(c.enters, c.enterPart, c.leavePart), load(best.part + at)),
              best.part + at);
        store(select(better, flag(c.enters), load(best.entering + at)), best.entering + at);
    }
    return improved;
}

HWY_INLINE bool isTriangle(const TreeEntry& entry) { return entry.corners[0] != TreeEntry::noTriangle; }
HWY_INLINE TriangleShape triangle(const World& world, const TreeEntry& entry) {
    return {world.faces.vertices.data(), entry.corners, world.faces.rounding};
}

/// Nearest crossings of all lanes; element is noElement where there is none.
HWY_NOINLINE void nearestHits(const World& world, const RayPacket& rays, HitPacket& best) {
    for (std::size_t at = 0; at < lanes; at += half) {
        store(set(Bounds::infinity), best.t + at);
        store(set(noElement), best.element + at);
        store(set(0), best.part + at);
        store(set(0), best.entering + at);
    }
    ShearPacket shear;
    if (!world.faces.faces.empty()) shear.shearAlong(rays, world.faces);
    const RoundingPacket rounding(rays, world.faces.rounding);
    const Lines lines{rays, shear, rounding};
    const auto test = [&](ElementId id, std::uint32_t mask) HWY_ATTR {
        return world.visit(id, [&](const auto& shape)
                                   HWY_ATTR { return improve(shape, laneOf(id.index), lines, mask, best); });
    };
    if (world.tree.empty()) {
        for (std::uint32_t i = 0; i < world.elements.size(); ++i) test({i}, allLanes);
        return;
    }
    for (const ElementId plane : world.unbounded) test(plane, allLanes);
    SlabPacket slab(world.tree, rays, best.t);
    traverse(world.tree, slab, [&](const TreeNode& leaf, std::uint32_t mask) HWY_ATTR {
        bool improved = false;
        for (std::uint32_t i = 0; i < leaf.count; ++i) {
            const TreeEntry& entry = world.tree.entries[leaf.first + i];
            improved |= isTriangle(entry)
                            ? improve(triangle(world, entry), laneOf(entry.element.index), lines, mask, best)
                            : test(entry.element, mask);
        }
        if (improved) slab.setMax(best.t);
        return false;
    });
}

} // namespace yarte::trace::HWY_NAMESPACE::YARTE_PRECISION
HWY_AFTER_NAMESPACE();

#endif
