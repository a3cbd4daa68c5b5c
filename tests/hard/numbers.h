// The oracle's numbers: exact rationals, and reals of 150 digits.
#pragma once

#include <boost/multiprecision/gmp.hpp>
#include <boost/multiprecision/mpfr.hpp>

#include <cmath>
#include <string>

namespace yarte::hard {

using Rational =
    boost::multiprecision::number<boost::multiprecision::gmp_rational, boost::multiprecision::et_off>;
using Real = boost::multiprecision::number<
    boost::multiprecision::mpfr_float_backend<150, boost::multiprecision::allocate_stack>,
    boost::multiprecision::et_off>;

template <class N>
struct Vec {
    N x, y, z;
};

template <class N>
Vec<N> operator+(const Vec<N>& a, const Vec<N>& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class N>
Vec<N> operator-(const Vec<N>& a, const Vec<N>& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class N>
Vec<N> operator*(const Vec<N>& a, const N& s) {
    return {a.x * s, a.y * s, a.z * s};
}
template <class N>
N dot(const Vec<N>& a, const Vec<N>& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class N>
Vec<N> cross(const Vec<N>& a, const Vec<N>& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// Half the distance of neighbouring doubles at x: what rounding may have moved x by. 0 is itself.
inline double halfUlp(double x) {
    if (x == 0) return 0;
    int exponent;
    std::frexp(x, &exponent);
    return std::ldexp(1.0, std::max(exponent - 54, -1075 + 1));
}

/// "1.25e-3", cut after `digits` significant ones.
inline std::string toText(const Real& value, int digits) {
    return value.str(digits, std::ios_base::scientific);
}

} // namespace yarte::hard
