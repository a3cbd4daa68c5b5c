// power, lane by lane, in double with the bits of yarte/trace/power.h.
#if defined(YARTE_TRACE_LANES_POWER_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef YARTE_TRACE_LANES_POWER_INL_H
#undef YARTE_TRACE_LANES_POWER_INL_H
#else
#define YARTE_TRACE_LANES_POWER_INL_H
#endif

#include "yarte/trace/lanes/vector-inl.h"
#include "yarte/trace/power.h"

HWY_BEFORE_NAMESPACE();
namespace yarte::trace::HWY_NAMESPACE::YARTE_PRECISION {

/// x^n for 0 < x <= 1 and n >= 0; lanes where it is below e^darkness are 0.
HWY_INLINE V power(V x, V n) {
    using C = PowerConstants<Scalar>;
    using I = hn::RebindToSigned<D>;
    using U = hn::RebindToUnsigned<D>;
    const D d;
    const U u;
    const V one = set(1);
    const M tooDark = n * (x - one) < set(darkness);
    const auto shifted = hn::BitCast(u, x) - hn::Set(u, C::sqrtHalf);
    const V m = hn::BitCast(d, hn::And(shifted, hn::Set(u, C::mantissa)) + hn::Set(u, C::sqrtHalf));
    // The exponent as a number: in the low bits of `rounder` it is an offset, whatever its sign.
    const auto exponent = hn::BitCast(u, hn::ShiftRight<C::mantissaBits>(hn::BitCast(I(), shifted)));
    const V e = hn::BitCast(d, exponent + hn::BitCast(u, set(C::rounder))) - set(C::rounder);
    const V s = (m - one) / (m + one), s2 = s * s;
    V series = set(0);
    for (const Scalar term : C::logTerms) series = series * s2 + set(term);
    const V y = n * (e * set(C::ln2High) + (e * set(C::ln2Low) + s * series));
    const M dark = hn::Or(tooDark, y < set(darkness));
    const V shiftedK = y * set(1 / (C::ln2High + C::ln2Low)) + set(C::rounder),
            k = shiftedK - set(C::rounder);
    const V r = (y - k * set(C::ln2High)) - k * set(C::ln2Low);
    V result = set(0);
    for (const Scalar term : C::expTerms) result = result * r + set(term);
    const auto kBits = hn::BitCast(u, shiftedK) - hn::BitCast(u, set(C::rounder));
    const V scale = hn::BitCast(d, hn::ShiftLeft<C::mantissaBits>(kBits + hn::Set(u, C::exponentBias)));
    return select(dark, set(0), result * scale);
}

} // namespace yarte::trace::HWY_NAMESPACE::YARTE_PRECISION
HWY_AFTER_NAMESPACE();

#endif
