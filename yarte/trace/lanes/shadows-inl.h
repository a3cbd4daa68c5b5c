// Searching the ways from a packet's points to a light for what blocks or dims it; see transmittance in
// yarte/trace/search.h.
#if defined(YARTE_TRACE_LANES_SHADOWS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef YARTE_TRACE_LANES_SHADOWS_INL_H
#undef YARTE_TRACE_LANES_SHADOWS_INL_H
#else
#define YARTE_TRACE_LANES_SHADOWS_INL_H
#endif

#include "yarte/trace/lanes/light_buffer-inl.h"
#include "yarte/trace/lanes/search-inl.h"

HWY_BEFORE_NAMESPACE();
namespace yarte::trace::HWY_NAMESPACE::YARTE_PRECISION {

/// What is known of the light of each lane while its way is searched; flags and counts as numbers.
struct alignas(64) ShadowPacket {
    /// Worlds with more distinct transmissions than this have their dimmed lanes traced one by one.
    static constexpr std::size_t maxLevels = 4;

    Scalar distance[lanes];
    Scalar blocked[lanes];
    /// Surfaces of each of World::transmissions; those beyond count in the last.
    Scalar crossed[maxLevels][lanes];
};

/// How far lanes are still searched for what blocks or dims their light: the way to the light, or nowhere.
struct alignas(64) ReachPacket {
    static constexpr Scalar nowhere = -1;
    Scalar t[lanes];

    HWY_INLINE bool isEmpty() const {
        M some = none();
        for (std::size_t at = 0; at < lanes; at += half) some = hn::Or(some, load(t + at) > set(0));
        return !any(some);
    }
    HWY_INLINE void keepOnly(std::uint32_t mask) {
        for (std::size_t at = 0; at < lanes; at += half)
            store(select(lanesIn(mask, at), load(t + at), set(nowhere)), t + at);
    }
    HWY_INLINE void stopBlocked(const ShadowPacket& shadow) {
        for (std::size_t at = 0; at < lanes; at += half)
            store(select(isSet(load(shadow.blocked + at)), set(nowhere), load(t + at)), t + at);
    }
};

/// Marks the lanes that the shape blocks within their reach, and counts where it dims them. True if it blocks
/// a lane.
template <class Shape>
HWY_INLINE bool castShadow(const Shape& shape, ElementId element, const World& world, const Lines& lines,
                           std::uint32_t mask, const ReachPacket& reach, ShadowPacket& shadow) {
    bool blocks = false;
    for (std::size_t at = 0; at < lanes; at += half) {
        if (bitsIn(mask, at) == 0) continue;
        const V limit = load(reach.t + at);
        const CrossingLanes c = ahead(shape, lines, at, laneOf(element.index), limit);
        const M enters = hn::And(c.enters, c.enter < limit), leaves = hn::And(c.leaves, c.leave < limit);
        const M crossed = hn::Or(enters, leaves);
        if (!any(crossed)) continue;
        const BodyAppearance& body = world.appearanceOf(element);
        if (isBlack(body.transmission)) {
            store(select(crossed, set(1), load(shadow.blocked + at)), shadow.blocked + at);
            blocks = true;
        } else {
            const std::size_t level =
                std::min<std::size_t>(body.transmissionLevel, ShadowPacket::maxLevels - 1);
            Scalar* count = shadow.crossed[level] + at;
            store(load(count) + flag(enters) + flag(leaves), count);
        }
    }
    return blocks;
}

/// The lanes with `values` equal to `value`.
HWY_INLINE std::uint32_t lanesWith(const Scalar* values, Scalar value) {
    std::uint32_t bits = 0;
    for (std::size_t at = 0; at < lanes; at += half)
        bits |= bitsOf(D(), load(values + at) == set(value)) << at;
    return bits;
}

/// Searches the shadows of one packet.
class ShadowSearch {
public:
    HWY_INLINE ShadowSearch(const World& world, const RayPacket& rays, ShadowPacket& shadow,
                            ElementId& blocker)
        : world_(world), rounding_(rays, world.faces.rounding), lines_{rays, shear_, rounding_},
          shadow_(shadow), blocker_(blocker) {
        if (!world.faces.faces.empty()) shear_.shearAlong(rays, world.faces);
    }

    /// True if it blocks a lane.
    HWY_INLINE bool test(ElementId id, std::uint32_t mask, const ReachPacket& reach) {
        const bool blocks = world_.visit(id, [&](const auto& shape) HWY_ATTR {
            return castShadow(shape, id, world_, lines_, mask, reach, shadow_);
        });
        if (blocks) blocker_ = id;
        return blocks;
    }
    HWY_INLINE bool test(const TreeEntry& entry, std::uint32_t mask, const ReachPacket& reach) {
        if (!isTriangle(entry)) return test(entry.element, mask, reach);
        const bool blocks =
            castShadow(triangle(world_, entry), entry.element, world_, lines_, mask, reach, shadow_);
        if (blocks) blocker_ = entry.element;
        return blocks;
    }

    /// Ends the search of all lanes but those in crowded cells.
    HWY_INLINE void searchBuffer(const LightBuffer& buffer, ReachPacket& reach) {
        const PlacePacket places(buffer, lines_.rays, reach.t);
        std::uint32_t crowded = 0;
        for (std::uint32_t left = allLanes & ~lanesWith(places.cell, PlacePacket::noCell); left != 0;) {
            const Scalar index = places.cell[std::countr_zero(left)];
            const std::uint32_t inCell = lanesWith(places.cell, index);
            left &= ~inCell;
            const LightBuffer::Cell& cell = buffer.cells[static_cast<std::size_t>(index)];
            if (cell.blockCount == LightBuffer::Cell::crowded)
                crowded |= inCell;
            else if (cell.blockCount > 0)
                searchCell(buffer, cell, StepRange(places, inCell), inCell, reach);
        }
        reach.keepOnly(crowded);
    }

    HWY_INLINE void searchCell(const LightBuffer& buffer, const LightBuffer::Cell& cell,
                               const StepRange& range, std::uint32_t inCell, const ReachPacket& all) {
        ReachPacket reach = all; // elements are seen in several cells, and must not count twice
        reach.keepOnly(inCell);
        for (std::uint32_t i = cell.firstBlock; i < cell.firstBlock + cell.blockCount; ++i) {
            const LightBuffer::Block& block = buffer.blocks[i];
            for (std::uint32_t items = itemsIn(block, cell, range); items != 0; items &= items - 1) {
                const std::uint32_t entry = block.entry[std::countr_zero(items)];
                if (!test(world_.tree.entries[entry], inCell, reach)) continue;
                reach.stopBlocked(shadow_);
                if (reach.isEmpty()) return;
            }
        }
    }

    HWY_INLINE void searchTree(ReachPacket& reach) {
        SlabPacket slab(world_.tree, lines_.rays, reach.t);
        traverse(world_.tree, slab, [&](const TreeNode& leaf, std::uint32_t mask) HWY_ATTR {
            bool blocks = false;
            for (std::uint32_t i = 0; i < leaf.count; ++i)
                blocks |= test(world_.tree.entries[leaf.first + i], mask, reach);
            if (!blocks) return false;
            reach.stopBlocked(shadow_);
            slab.setMax(reach.t);
            return reach.isEmpty();
        });
    }

private:
    const World& world_;
    ShearPacket shear_;
    RoundingPacket rounding_;
    Lines lines_;
    ShadowPacket& shadow_;
    ElementId& blocker_;
};

/// Marks the lanes whose way to the light is blocked, and counts what dims it. Lanes that start as blocked
/// are not looked at. `blocker` is what blocked the light last, or none: it is likely to do so again and is
/// looked at first.
HWY_NOINLINE void findShadows(const World& world, const RayPacket& rays, const LightBuffer& buffer,
                              ShadowPacket& shadow, ElementId& blocker) {
    ReachPacket reach;
    std::copy_n(shadow.distance, lanes, reach.t);
    reach.stopBlocked(shadow);
    ShadowSearch search(world, rays, shadow, blocker);
    const auto test = [&](ElementId id) HWY_ATTR {
        if (search.test(id, allLanes, reach)) reach.stopBlocked(shadow);
        return reach.isEmpty();
    };
    if (blocker != ElementId{} && test(blocker)) return;
    if (world.tree.empty()) {
        for (std::uint32_t i = 0; i < world.elements.size(); ++i)
            if (test({i})) return;
        return;
    }
    for (const ElementId plane : world.unbounded)
        if (test(plane)) return;
    if (!buffer.empty()) {
        search.searchBuffer(buffer, reach);
        if (reach.isEmpty()) return;
    }
    search.searchTree(reach);
}

} // namespace yarte::trace::HWY_NAMESPACE::YARTE_PRECISION
HWY_AFTER_NAMESPACE();

#endif
