// Powers of values in [0, 1000] to the exponents that FLIP has, exact to 1e-8 and without a branch or a call,
// so that compilers make vector code of loops over them.
#pragma once

#include <bit>
#include <cstdint>
#include <numbers>

namespace yarte::validate::flip {

/// log2 of a positive, normal x. x = 2^k m with m in [sqrt(1/2), sqrt(2)); log m = 2 artanh s, s = (m - 1)/(m
/// + 1).
inline double log2Of(double x) {
    constexpr std::uint64_t oneBits = 0x3ff0'0000'0000'0000, mantissaMask = 0x000f'ffff'ffff'ffff;
    constexpr std::uint64_t rootOfHalfBits = 0x3fe6'a09e'667f'3bcd;
    // Bits counted from those of sqrt(1/2): their upper part is k, their lower part says where m lies.
    const std::uint64_t bits = std::bit_cast<std::uint64_t>(x) + (oneBits - rootOfHalfBits);
    const double m = std::bit_cast<double>((bits & mantissaMask) + rootOfHalfBits);
    // k as a double: the biased exponent below the point of 2^52.
    constexpr double twoTo52 = 0x1p52;
    const double k =
        std::bit_cast<double>((bits >> 52) | std::bit_cast<std::uint64_t>(twoTo52)) - (twoTo52 + 1023);
    const double s = (m - 1) / (m + 1), q = s * s;
    const double series = 1 + q * (1.0 / 3 + q * (1.0 / 5 + q * (1.0 / 7 + q * (1.0 / 9 + q / 11))));
    return k + 2 * std::numbers::log2e * s * series;
}

/// 2^x for x in [-1000, 1000]: 2^k by its bits, the rest, at most 1/2, by the series of e^r.
inline double exp2Of(double x) {
    constexpr double roundToInteger =
        0x1.8p52; // adding it leaves the nearest whole number in the lowest bits
    const double shifted = x + roundToInteger;
    const double r = (x - (shifted - roundToInteger)) * std::numbers::ln2;
    const double series =
        1 +
        r * (1 + r / 2 * (1 + r / 3 * (1 + r / 4 * (1 + r / 5 * (1 + r / 6 * (1 + r / 7 * (1 + r / 8)))))));
    return series * std::bit_cast<double>((std::bit_cast<std::uint64_t>(shifted) + 1023) << 52);
}

/// base^exponent, for base >= 0 and 0 < exponent <= 1; 0^exponent is 0.
inline double power(double base, double exponent) {
    constexpr double tiny = 0x1p-1000; // log2Of knows no 0
    const double found = exp2Of(exponent * log2Of(base > tiny ? base : tiny));
    return base > 0 ? found : 0.0;
}

} // namespace yarte::validate::flip
