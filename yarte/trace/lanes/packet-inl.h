// Packets: rays and hits side by side, one lane each.
#if defined(YARTE_TRACE_LANES_PACKET_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef YARTE_TRACE_LANES_PACKET_INL_H
#undef YARTE_TRACE_LANES_PACKET_INL_H
#else
#define YARTE_TRACE_LANES_PACKET_INL_H
#endif

#include "yarte/trace/lanes/vector-inl.h"
#include "yarte/trace/ray.h"

HWY_BEFORE_NAMESPACE();
namespace yarte::trace::HWY_NAMESPACE {

/// Element ids, sides and parts are kept as doubles: they are exact, and blend with the same masks.
inline constexpr double noElement = 4294967295.0;

struct alignas(64) RayPacket {
    double ox[lanes], oy[lanes], oz[lanes]; ///< origin
    double dx[lanes], dy[lanes], dz[lanes]; ///< unit direction
    double from[lanes];                     ///< element left, or noElement
    double inside[lanes];                   ///< 1: left to its inside

    HWY_INLINE V3 origin(std::size_t at) const { return {load(ox + at), load(oy + at), load(oz + at)}; }
    HWY_INLINE V3 direction(std::size_t at) const { return {load(dx + at), load(dy + at), load(dz + at)}; }
    HWY_INLINE void setOrigin(std::size_t at, V3 v) {
        store(v.x, ox + at), store(v.y, oy + at), store(v.z, oz + at);
    }
    HWY_INLINE void setDirection(std::size_t at, V3 v) {
        store(v.x, dx + at), store(v.y, dy + at), store(v.z, dz + at);
    }
    Ray ray(std::size_t lane) const {
        Ray r{{ox[lane], oy[lane], oz[lane]}, {dx[lane], dy[lane], dz[lane]}, {}};
        r.from.element.index = static_cast<std::uint32_t>(from[lane]);
        r.from.side = inside[lane] != 0 ? Side::inside : Side::outside;
        return r;
    }
};

/// Shear of yarte/trace/face.h as two rows that a vertex is multiplied with: the components that the scalar
/// form leaves out are exact zeros. One for a packet, however many faces it meets.
struct alignas(64) ShearPacket {
    double rows[6][lanes];

    HWY_INLINE void shearAlong(const RayPacket& rays) {
        for (std::size_t at = 0; at < lanes; at += half) {
            const V3 d = rays.direction(at);
            const V zero = set(0), one = set(1);
            const V ax = hn::Abs(d.x), ay = hn::Abs(d.y), az = hn::Abs(d.z);
            const M axisX = hn::And(ax > ay, ax > az), axisY = hn::AndNot(ax > ay, ay > az);
            const V pz = select(axisX, d.x, select(axisY, d.y, d.z));
            const V px = select(axisX, d.y, select(axisY, d.z, d.x));
            const V py = select(axisX, d.z, select(axisY, d.x, d.y));
            const V slopeX = hn::Neg(px / pz), slopeY = hn::Neg(py / pz);
            store(select(axisX, slopeX, select(axisY, zero, one)), rows[0] + at);
            store(select(axisX, one, select(axisY, slopeX, zero)), rows[1] + at);
            store(select(axisX, zero, select(axisY, one, slopeX)), rows[2] + at);
            store(select(axisX, slopeY, select(axisY, one, zero)), rows[3] + at);
            store(select(axisX, zero, select(axisY, slopeY, one)), rows[4] + at);
            store(select(axisX, one, select(axisY, zero, slopeY)), rows[5] + at);
        }
    }
    HWY_INLINE V3 row(std::size_t first, std::size_t at) const {
        return {load(rows[first] + at), load(rows[first + 1] + at), load(rows[first + 2] + at)};
    }
};

struct alignas(64) HitPacket {
    double t[lanes], element[lanes], part[lanes], entering[lanes];
};

/// The crossings of one half's lines with a shape: where they enter it and where they leave it.
struct CrossingLanes {
    V enter, leave, enterPart, leavePart;
    M enters, leaves; ///< which of them there are
};

} // namespace yarte::trace::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
