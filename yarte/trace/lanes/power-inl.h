// power, lane by lane the bits of yarte/trace/power.h.
#if defined(YARTE_TRACE_LANES_POWER_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef YARTE_TRACE_LANES_POWER_INL_H
#undef YARTE_TRACE_LANES_POWER_INL_H
#else
#define YARTE_TRACE_LANES_POWER_INL_H
#endif

#include "yarte/trace/lanes/vector-inl.h"
#include "yarte/trace/power.h"

HWY_BEFORE_NAMESPACE();
namespace yarte::trace::HWY_NAMESPACE {

/// x^n for 0 < x <= 1 and n >= 0; lanes where it is below e^darkness are 0.
HWY_INLINE V power(V x, V n) {
    using namespace power_constants;
    using I = hn::RebindToSigned<D>;
    using U = hn::RebindToUnsigned<D>;
    const D d;
    const U u;
    const V one = set(1);
    const M tooDark = n * (x - one) < set(darkness);
    const auto shifted = hn::BitCast(u, x) - hn::Set(u, sqrtHalf);
    const V m = hn::BitCast(d, hn::And(shifted, hn::Set(u, 0x000fffffffffffff)) + hn::Set(u, sqrtHalf));
    // The exponent as a double: in the low bits of 2^52 + 2^51 it is an offset, whatever its sign.
    const auto exponent = hn::BitCast(u, hn::ShiftRight<52>(hn::BitCast(I(), shifted)));
    const V e = hn::BitCast(d, exponent + hn::BitCast(u, set(rounder))) - set(rounder);
    const V s = (m - one) / (m + one), s2 = s * s;
    V series = set(0);
    for (const double term : logTerms) series = series * s2 + set(term);
    const V y = n * (e * set(ln2High) + (e * set(ln2Low) + s * series));
    const M dark = hn::Or(tooDark, y < set(darkness));
    const V shiftedK = y * set(1 / (ln2High + ln2Low)) + set(rounder), k = shiftedK - set(rounder);
    const V r = (y - k * set(ln2High)) - k * set(ln2Low);
    V result = set(0);
    for (const double term : expTerms) result = result * r + set(term);
    const auto k64 = hn::BitCast(u, shiftedK) - hn::BitCast(u, set(rounder));
    const V scale = hn::BitCast(d, hn::ShiftLeft<52>(k64 + hn::Set(u, 1023)));
    return select(dark, set(0), result * scale);
}

} // namespace yarte::trace::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
