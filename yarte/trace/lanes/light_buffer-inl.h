// What a light buffer tells of the ways from a packet's rays to the light.
#if defined(YARTE_TRACE_LANES_LIGHT_BUFFER_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef YARTE_TRACE_LANES_LIGHT_BUFFER_INL_H
#undef YARTE_TRACE_LANES_LIGHT_BUFFER_INL_H
#else
#define YARTE_TRACE_LANES_LIGHT_BUFFER_INL_H
#endif

#include "yarte/trace/lanes/packet-inl.h"
#include "yarte/trace/light_buffer.h"

#include <bit>

HWY_BEFORE_NAMESPACE();
namespace yarte::trace::HWY_NAMESPACE::YARTE_PRECISION {

/// Where each lane's start is seen from the light.
struct alignas(64) PlacePacket {
    static constexpr Scalar noCell = -1;
    Scalar cell[lanes];        ///< noCell where nothing can be in the way
    Scalar u[lanes], v[lanes]; ///< steps in the cell
    Scalar depth[lanes];       ///< along the face's axis

    /// Of the lanes whose `reach` is not negative.
    HWY_INLINE PlacePacket(const LightBuffer& buffer, const RayPacket& rays, const Scalar* reach) {
        for (std::size_t at = 0; at < lanes; at += half) {
            const V3 from = rays.origin(at) - spread(buffer.light);
            const M isSearched = load(reach + at) >= set(0);
            store(set(noCell), cell + at);
            for (const LightBuffer::Face& face : buffer.faces) placeOn(face, from, isSearched, at);
        }
    }

private:
    HWY_INLINE void placeOn(const LightBuffer::Face& face, V3 from, M isSearched, std::size_t at) {
        const V3 way = face.axis == 0   ? V3{from.y, from.z, from.x}
                       : face.axis == 1 ? V3{from.z, from.x, from.y}
                                        : from;
        const V ahead = face.isDownwards ? hn::Neg(way.z) : way.z;
        const M isSeen = hn::And(hn::And(ahead > set(0), isSearched),
                                 hn::And(hn::Abs(way.x) <= ahead, hn::Abs(way.y) <= ahead));
        if (!any(isSeen)) return;
        constexpr double steps = LightBuffer::stepsPerCell;
        const V x = hn::Floor((way.x / ahead - set(face.uLow)) * set(face.uScale)),
                y = hn::Floor((way.y / ahead - set(face.vLow)) * set(face.vScale));
        const V column = hn::Floor(x * set(1 / steps)), row = hn::Floor(y * set(1 / steps));
        const M inGrid = hn::And(hn::And(x >= set(0), column < set(face.columns)),
                                 hn::And(y >= set(0), row < set(face.rows)));
        const M isHere = hn::And(isSeen, inGrid);
        const V index = set(face.firstCell) + row * set(face.columns) + column;
        store(select(isHere, index, load(cell + at)), cell + at);
        store(select(isHere, x - column * set(steps), load(u + at)), u + at);
        store(select(isHere, y - row * set(steps), load(v + at)), v + at);
        store(select(isHere, ahead, load(depth + at)), depth + at);
    }
};

/// The steps of a cell in which some lanes lie.
struct StepRange {
    Scalar uLow = 255, uHigh = 0, vLow = 255, vHigh = 0, depth = 0;

    HWY_INLINE StepRange(const PlacePacket& places, std::uint32_t lanesInCell) {
        for (; lanesInCell != 0; lanesInCell &= lanesInCell - 1) {
            const int lane = std::countr_zero(lanesInCell);
            uLow = std::min(uLow, places.u[lane]), uHigh = std::max(uHigh, places.u[lane]);
            vLow = std::min(vLow, places.v[lane]), vHigh = std::max(vHigh, places.v[lane]);
            depth = std::max(depth, places.depth[lane]);
        }
    }
};

/// The elements of a block that may be in the way, a bit each.
HWY_INLINE std::uint32_t itemsIn(const LightBuffer::Block& block, const LightBuffer::Cell& cell,
                                 const StepRange& range) {
    const hn::CappedTag<std::uint8_t, LightBuffer::Block::size> d;
    const auto step = [&](Scalar value) HWY_ATTR { return hn::Set(d, static_cast<std::uint8_t>(value)); };
    const auto isAtMost = [&](auto a, auto b) HWY_ATTR { return hn::Max(a, b) == b; };
    std::uint32_t items = 0;
    for (std::size_t i = 0; i < LightBuffer::Block::size; i += hn::Lanes(d)) {
        const auto list = [&](const std::uint8_t* of) HWY_ATTR { return hn::Load(d, of + i); };
        const auto inColumns = hn::And(isAtMost(list(block.uLow), step(range.uHigh)),
                                       isAtMost(step(range.uLow), list(block.uHigh)));
        const auto inRows = hn::And(isAtMost(list(block.vLow), step(range.vHigh)),
                                    isAtMost(step(range.vLow), list(block.vHigh)));
        const auto isNearer =
            isAtMost(list(block.depth), hn::Set(d, cell.depthStep(static_cast<float>(range.depth))));
        items |= bitsOf(d, hn::And(isNearer, hn::And(inColumns, inRows))) << i;
    }
    return items;
}

} // namespace yarte::trace::HWY_NAMESPACE::YARTE_PRECISION
HWY_AFTER_NAMESPACE();

#endif
