// Surface points of a packet: where, whose, and of what colours.
#if defined(YARTE_TRACE_LANES_POINTS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef YARTE_TRACE_LANES_POINTS_INL_H
#undef YARTE_TRACE_LANES_POINTS_INL_H
#else
#define YARTE_TRACE_LANES_POINTS_INL_H
#endif

#include "yarte/trace/lanes/packet-inl.h"

#include <type_traits>

HWY_BEFORE_NAMESPACE();
namespace yarte::trace::HWY_NAMESPACE::YARTE_PRECISION {

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
HWY_INLINE M isLit(V v) { return v != set(0); }
HWY_INLINE M isLit(C3 c) {
    const V zero = set(0);
    return hn::Or(c.r != zero, hn::Or(c.g != zero, c.b != zero));
}

struct alignas(64) ColourPacket {
    Scalar r[lanes], g[lanes], b[lanes];
    HWY_INLINE C3 at(std::size_t i) const { return {load(r + i), load(g + i), load(b + i)}; }
    HWY_INLINE void set(std::size_t i, C3 c) { store(c.r, r + i), store(c.g, g + i), store(c.b, b + i); }
    void set(std::size_t lane, Colour c) {
        r[lane] = static_cast<Scalar>(c.r), g[lane] = static_cast<Scalar>(c.g);
        b[lane] = static_cast<Scalar>(c.b);
    }
};

struct alignas(64) GreyPacket {
    Scalar v[lanes];
    HWY_INLINE V at(std::size_t i) const { return load(v + i); }
    HWY_INLINE void set(std::size_t i, V value) { store(value, v + i); }
    void set(std::size_t lane, Colour c) { v[lane] = static_cast<Scalar>(c.r); }
};

/// What is left of light on its way: one number for all channels, unless there are tints in the world.
template <bool isTinted>
using Passing = std::conditional_t<isTinted, C3, V>;
template <bool isTinted>
using PassingPacket = std::conditional_t<isTinted, ColourPacket, GreyPacket>;

/// The same for all channels.
template <bool isTinted>
HWY_INLINE Passing<isTinted> passing(V v) {
    if constexpr (isTinted)
        return {v, v, v};
    else
        return v;
}
template <bool isTinted>
HWY_INLINE Passing<isTinted> passing(Colour c) {
    if constexpr (isTinted)
        return spread(c);
    else
        return set(c.r);
}

/// Surface points and their materials, lane by lane. Lanes without a hit hold nothing that counts.
struct alignas(64) PointPacket {
    Scalar px[lanes], py[lanes], pz[lanes]; ///< position
    Scalar nx[lanes], ny[lanes], nz[lanes]; ///< unit normal, turned to face the viewer
    Scalar exponent[lanes], reflection[lanes];
    Scalar totalReflection[lanes]; ///< 0 where nothing passes
    ColourPacket ambient, diffuse, specular;

    HWY_INLINE V3 position(std::size_t i) const { return {load(px + i), load(py + i), load(pz + i)}; }
    HWY_INLINE V3 normal(std::size_t i) const { return {load(nx + i), load(ny + i), load(nz + i)}; }
    HWY_INLINE void setNormal(std::size_t i, V3 n) {
        store(n.x, nx + i), store(n.y, ny + i), store(n.z, nz + i);
    }
};

} // namespace yarte::trace::HWY_NAMESPACE::YARTE_PRECISION
HWY_AFTER_NAMESPACE();

#endif
