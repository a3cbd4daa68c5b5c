// Vectors of lanes: the names and few helpers that the kernels share. Every operation here rounds as its
// scalar namesake does, and none is fused: a lane computes the bits that scalar code computes.
//
// This and the other -inl.h files are compiled once per instruction set and scalar type: see lanes.cpp,
// scalar.h and Highway's documentation.
#if defined(YARTE_TRACE_LANES_VECTOR_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef YARTE_TRACE_LANES_VECTOR_INL_H
#undef YARTE_TRACE_LANES_VECTOR_INL_H
#else
#define YARTE_TRACE_LANES_VECTOR_INL_H
#endif

#include "yarte/base/colour.h"
#include "yarte/base/vec3.h"
#include "yarte/trace/lanes/scalar.h"

#include <hwy/highway.h>

#include <cstddef>

HWY_BEFORE_NAMESPACE();
namespace yarte::trace::HWY_NAMESPACE::YARTE_PRECISION {

namespace hn = hwy::HWY_NAMESPACE;
using namespace trace::YARTE_PRECISION;

using D = hn::ScalableTag<Scalar>;
using F = hn::ScalableTag<float>;
using V = hn::Vec<D>;
using M = hn::Mask<D>;
using VF = hn::Vec<F>;
using MF = hn::Mask<F>;

/// Rays in a packet: one float vector of boxes; of shapes one vector, too, or in double two ("halves").
inline constexpr std::size_t lanes = HWY_LANES(float);
inline constexpr std::size_t half = HWY_LANES(Scalar);

HWY_INLINE V set(double x) { return hn::Set(D(), static_cast<Scalar>(x)); }
HWY_INLINE V load(const Scalar* from) { return hn::Load(D(), from); }
HWY_INLINE void store(V v, Scalar* to) { hn::Store(v, D(), to); }
HWY_INLINE V select(M mask, V yes, V no) { return hn::IfThenElse(mask, yes, no); }
HWY_INLINE V least(V a, V b) { return select(b < a, b, a); }    // std::min
HWY_INLINE V greatest(V a, V b) { return select(a < b, b, a); } // std::max
HWY_INLINE bool any(M mask) { return !hn::AllFalse(D(), mask); }
HWY_INLINE M none() { return set(0) != set(0); }
HWY_INLINE M isSet(V flag) { return flag != set(0); }
HWY_INLINE V flag(M mask) { return hn::IfThenElseZero(mask, set(1)); }

/// Lanes of a packet as bits.
inline constexpr std::uint32_t allLanes = (std::uint64_t{1} << lanes) - 1;

/// The lanes that are on, from bit 0.
template <class Tag>
HWY_INLINE std::uint32_t bitsOf(Tag tag, hn::Mask<Tag> mask) {
    std::uint8_t bytes[8] = {};
    hn::StoreMaskBits(tag, mask, bytes);
    return bytes[0] | static_cast<std::uint32_t>(bytes[1]) << 8;
}

/// Those of `bits` in the half of a packet that starts at lane `at`.
HWY_INLINE std::uint32_t bitsIn(std::uint32_t bits, std::size_t at) {
    return bits >> at & ((1u << half) - 1);
}
HWY_INLINE M lanesIn(std::uint32_t bits, std::size_t at) {
    const std::uint32_t mine = bitsIn(bits, at);
    const std::uint8_t bytes[8] = {static_cast<std::uint8_t>(mine), static_cast<std::uint8_t>(mine >> 8)};
    return hn::LoadMaskBits(D(), bytes);
}

using LaneNumber = hn::TFromD<hn::RebindToSigned<D>>;

/// Writes the numbers of the lanes that are on to `order`, which has room for one more than there are lanes,
/// and returns how many. What follows them is a valid lane number too.
HWY_INLINE std::size_t listLanes(M mask, LaneNumber* order) {
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(D(), mask, bits);
    std::size_t count = 0;
    for (std::size_t i = 0; i <= half; ++i) order[i] = 0;
    for (std::size_t i = 0; i < half; ++i) {
        order[count] = static_cast<LaneNumber>(i);
        count += bits[i / 8] >> i % 8 & 1;
    }
    return count;
}

struct V3 {
    V x, y, z;
};

HWY_INLINE V3 spread(Vec3 v) { return {set(v.x), set(v.y), set(v.z)}; }
HWY_INLINE V3 operator+(V3 a, V3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
HWY_INLINE V3 operator-(V3 a, V3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
HWY_INLINE V3 operator*(V3 a, V s) { return {a.x * s, a.y * s, a.z * s}; }
HWY_INLINE V3 operator/(V3 a, V s) { return {a.x / s, a.y / s, a.z / s}; }
HWY_INLINE V dot(V3 a, V3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
HWY_INLINE V3 normalised(V3 a) { return a / hn::Sqrt(dot(a, a)); }
HWY_INLINE V3 select(M mask, V3 yes, V3 no) {
    return {select(mask, yes.x, no.x), select(mask, yes.y, no.y), select(mask, yes.z, no.z)};
}
HWY_INLINE V3 negated(V3 a) { return {hn::Neg(a.x), hn::Neg(a.y), hn::Neg(a.z)}; }

/// Components along the axes of a frame; see Frame::toLocal and toWorld.
template <class Axes>
HWY_INLINE V3 toLocal(const Axes& f, V3 v) {
    return {dot(v, spread(f.x)), dot(v, spread(f.y)), dot(v, spread(f.z))};
}
template <class Axes>
HWY_INLINE V3 toWorld(const Axes& f, V3 v) {
    return spread(f.x) * v.x + spread(f.y) * v.y + spread(f.z) * v.z;
}

} // namespace yarte::trace::HWY_NAMESPACE::YARTE_PRECISION
HWY_AFTER_NAMESPACE();

#endif
