// power: Phong's x^n from the four operations alone, so that scalar code and every lane width give the same
// bits.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

namespace yarte::trace {

/// Below e^darkness a highlight adds nothing that a double's last bits of white could show: such lanes are 0.
inline constexpr double darkness = -40;

/// Of a scalar type: how many terms its precision asks for, and how its numbers are made of bits.
template <class Scalar>
struct PowerConstants;

template <>
struct PowerConstants<double> {
    /// 2/(2k+1): log m = 2 atanh(s) = sum of 2 s^(2k+1)/(2k+1), s = (m-1)/(m+1). |s| <= 0.172, so eleven
    /// terms reach 2^-55.
    static constexpr double logTerms[] = {2. / 21, 2. / 19, 2. / 17, 2. / 15, 2. / 13, 2. / 11,
                                          2. / 9,  2. / 7,  2. / 5,  2. / 3,  2.};
    /// 1/k!: e^r for |r| <= ln 2 / 2, thirteen terms reach 2^-57.
    static constexpr double expTerms[] = {
        1. / 6227020800, 1. / 479001600, 1. / 39916800, 1. / 3628800, 1. / 362880, 1. / 40320, 1. / 5040,
        1. / 720,        1. / 120,       1. / 24,       1. / 6,       1. / 2,      1.,         1.};
    /// ln 2 in two parts: the first has so few bits that products with exponents are exact.
    static constexpr double ln2High = 0x1.62e42fefap-1, ln2Low = 0x1.cf79abc9e3b3ap-40;
    static constexpr double rounder = 0x1.8p52; ///< adding and subtracting it rounds to an integer
    using Bits = std::uint64_t;
    static constexpr Bits sqrtHalf = 0x3fe6a09e667f3bcd; ///< the bits of sqrt(1/2)
    static constexpr int mantissaBits = 52, exponentBias = 1023;
    static constexpr Bits mantissa = (Bits{1} << mantissaBits) - 1;
};

template <>
struct PowerConstants<float> {
    /// Five terms reach 2^-27.
    static constexpr float logTerms[] = {2.f / 9, 2.f / 7, 2.f / 5, 2.f / 3, 2.f};
    /// Eight terms reach 2^-27.
    static constexpr float expTerms[] = {1.f / 5040, 1.f / 720, 1.f / 120, 1.f / 24,
                                         1.f / 6,    1.f / 2,   1.f,       1.f};
    static constexpr float ln2High = 0x1.62e3p-1f, ln2Low = 0x1.2fefa2p-17f;
    static constexpr float rounder = 0x1.8p23f;
    using Bits = std::uint32_t;
    static constexpr Bits sqrtHalf = 0x3f3504f3;
    static constexpr int mantissaBits = 23, exponentBias = 127;
    static constexpr Bits mantissa = (Bits{1} << mantissaBits) - 1;
};

/// x^n for 0 < x <= 1 (a little above 1 by rounding is fine) and n >= 0, to a few ulps; 0 where it is below
/// e^darkness.
inline double power(double x, double n) {
    using C = PowerConstants<double>;
    if (n * (x - 1) < darkness) return 0; // ln x <= x - 1
    // x = m 2^e with m in [sqrt(1/2), sqrt 2)
    const std::uint64_t bits = std::bit_cast<std::uint64_t>(x);
    const std::uint64_t shifted = bits - C::sqrtHalf;
    const double m = std::bit_cast<double>((shifted & C::mantissa) + C::sqrtHalf);
    const double e = static_cast<double>(static_cast<std::int64_t>(shifted) >> C::mantissaBits);
    const double s = (m - 1) / (m + 1), s2 = s * s;
    double series = 0;
    for (const double term : C::logTerms) series = series * s2 + term;
    const double y = n * (e * C::ln2High + (e * C::ln2Low + s * series));
    if (y < darkness) return 0;
    const double k = (y * (1 / (C::ln2High + C::ln2Low)) + C::rounder) - C::rounder;
    const double r = (y - k * C::ln2High) - k * C::ln2Low;
    double result = 0;
    for (const double term : C::expTerms) result = result * r + term;
    return result *
           std::bit_cast<double>((C::exponentBias + static_cast<std::uint64_t>(static_cast<std::int64_t>(k)))
                                 << C::mantissaBits);
}

} // namespace yarte::trace
