// Packets: rays and hits side by side, one lane each.
#if defined(YARTE_TRACE_LANES_PACKET_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef YARTE_TRACE_LANES_PACKET_INL_H
#undef YARTE_TRACE_LANES_PACKET_INL_H
#else
#define YARTE_TRACE_LANES_PACKET_INL_H
#endif

#include "yarte/trace/face.h"
#include "yarte/trace/lanes/vector-inl.h"
#include "yarte/trace/ray.h"

HWY_BEFORE_NAMESPACE();
namespace yarte::trace::HWY_NAMESPACE::YARTE_PRECISION {

/// Sides, parts and flags are small numbers, ids what laneOf makes of them: they blend with the same masks as
/// all else.
struct alignas(64) RayPacket {
    Scalar ox[lanes], oy[lanes], oz[lanes]; ///< origin
    Scalar dx[lanes], dy[lanes], dz[lanes]; ///< unit direction
    Scalar from[lanes];                     ///< element left, or noElement
    Scalar inside[lanes];                   ///< 1: left to its inside

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
        r.from.element.index = idIn(from[lane]);
        r.from.side = inside[lane] != 0 ? Side::inside : Side::outside;
        return r;
    }
};

/// Shear of yarte/trace/face.h. Computed once for a packet, however many faces it meets.
struct alignas(64) ShearPacket {
    Scalar slopeX[lanes], slopeY[lanes];
    /// What the determinant of an edge may be off by at most, wherever the vertices are.
    Scalar blur[lanes];
    Scalar axisX[lanes], axisY[lanes]; ///< flags: the direction's largest component is that one; neither: z
    /// The same for all lanes: 0, 1, 2; or `mixed`, and the lanes choose by their flags.
    static constexpr int mixed = -1;
    int axis;

    HWY_INLINE void shearAlong(const RayPacket& rays, const FaceTable& table) {
        std::size_t alongX = 0, alongY = 0;
        for (std::size_t at = 0; at < lanes; at += half) {
            const V3 o = rays.origin(at), d = rays.direction(at);
            // Of a vertex as it is seen x and y are at most twice as far away, and so is z.
            const V far = set(table.largest) + hn::Abs(o.x) + hn::Abs(o.y) + hn::Abs(o.z);
            store(set(4 * edgeBlur) * far * far, blur + at);
            const V ax = hn::Abs(d.x), ay = hn::Abs(d.y), az = hn::Abs(d.z);
            const M isX = hn::And(ax > ay, ax > az), isY = hn::AndNot(ax > ay, ay > az);
            const V3 p = rotated(isX, isY, d);
            store(p.x / p.z, slopeX + at), store(p.y / p.z, slopeY + at);
            store(flag(isX), axisX + at), store(flag(isY), axisY + at);
            alongX += hn::CountTrue(D(), isX), alongY += hn::CountTrue(D(), isY);
        }
        axis = alongX == lanes ? 0 : alongY == lanes ? 1 : alongX + alongY == 0 ? 2 : mixed;
    }

    /// Where the lanes see `vertex`: see Seen.
    HWY_INLINE V3 see(const V3& origin, std::size_t at, Vec3 vertex) const {
        const V3 p = spread(vertex) - origin;
        const V3 q = axis == 2   ? p
                     : axis == 0 ? V3{p.y, p.z, p.x}
                     : axis == 1 ? V3{p.z, p.x, p.y}
                                 : rotated(isSet(load(axisX + at)), isSet(load(axisY + at)), p);
        return {q.x - load(slopeX + at) * q.z, q.y - load(slopeY + at) * q.z, q.z};
    }

private:
    HWY_INLINE static V3 rotated(M isX, M isY, V3 v) {
        return {select(isX, v.y, select(isY, v.z, v.x)), select(isX, v.z, select(isY, v.x, v.y)),
                select(isX, v.x, select(isY, v.y, v.z))};
    }
};

/// A line that starts so near to a surface starts on it, as far as its rounded coordinates tell. In float
/// that is a part of the distance from the camera, which is at the origin: less than a pixel's width (see
/// suitsFloat in build_world.cpp).
struct alignas(64) RoundingPacket {
    Scalar distance[lanes];

    HWY_INLINE RoundingPacket(const RayPacket& rays, double ofDoubles) {
        for (std::size_t at = 0; at < lanes; at += half) {
            const V3 o = rays.origin(at);
            store(isFloat ? (hn::Abs(o.x) + hn::Abs(o.y) + hn::Abs(o.z)) * set(0x1p-18) : set(ofDoubles),
                  distance + at);
        }
    }
    HWY_INLINE V at(std::size_t i) const { return load(distance + i); }
};

struct alignas(64) HitPacket {
    Scalar t[lanes], element[lanes], part[lanes], entering[lanes];

    HWY_INLINE bool isEmpty() const {
        M some = none();
        for (std::size_t at = 0; at < lanes; at += half)
            some = hn::Or(some, load(element + at) != set(noElement));
        return !any(some);
    }
};

/// The crossings of one half's lines with a shape: where they enter it and where they leave it.
struct CrossingLanes {
    V enter, leave, enterPart, leavePart;
    M enters, leaves; ///< which of them there are
    M doubtful;       ///< as Crossings::isDoubtful
};

} // namespace yarte::trace::HWY_NAMESPACE::YARTE_PRECISION
HWY_AFTER_NAMESPACE();

#endif
