// Decisions: signs of numbers, with what proves them.
#pragma once

#include "tests/hard/uncertain.h"

#include <array>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace yarte::hard {

/// A sign, and the number whose sign decided it.
struct Decision {
    int sign = 0;
    /// |value| over how far the inputs' rounding may move it: above 1 the decision is certain; infinite if
    /// nothing moves it.
    double strength = 0;
    const char* what = ""; ///< the number's name
    Real value;
    double range = 0;

    bool isCertain() const { return strength > 1; }
};

inline const Decision& weaker(const Decision& a, const Decision& b) {
    return b.strength < a.strength ? b : a;
}
inline const Decision& stronger(const Decision& a, const Decision& b) {
    return b.strength > a.strength ? b : a;
}

inline Decision signOf(const Uncertain& x, const char* what) {
    const int sign = x.value().sign();
    const double range = x.range(), size = std::abs(static_cast<double>(x.value()));
    // Without range 0 is a certain sign, too. The shares are doubles: the last bits of their sum do not
    // count.
    const double strength = range == 0             ? std::numeric_limits<double>::infinity()
                            : std::isfinite(range) ? size / range * (1 - 1e-9)
                                                   : 0;
    return {sign, strength, what, x.value(), range};
}
/// Exact inputs: certain.
inline Decision signOf(const Rational& x, const char* what) {
    return {x.sign(), std::numeric_limits<double>::infinity(), what, Real(x), 0};
}

inline bool isExactlyZero(const Decision& d) { return d.sign == 0 && d.isCertain(); }

/// p + q sqrt(d), d >= 0; what linear functions of the roots of a quadratic equation are.
template <class N>
struct Surd {
    N p = 0, q = 0, d = 0;
};

/// By squaring: nothing is rounded.
template <class N>
Decision signOf(const Surd<N>& s, const char* what) {
    Decision p = signOf(s.p, what);
    const Decision q = signOf(s.q, what), d = signOf(s.d, what);
    if (isExactlyZero(q) || isExactlyZero(d)) return p;
    Decision difference = signOf(s.p * s.p - s.q * s.q * s.d, what);
    if (difference.sign > 0) { // |p| is the larger: then p's sign is as certain as that
        difference.sign = p.sign;
        return p.sign == q.sign ? stronger(p, difference) : difference;
    }
    difference.sign = difference.sign < 0 ? q.sign : p.sign == q.sign ? p.sign : 0;
    return p.sign == q.sign ? stronger(p, difference) : difference;
}

inline Uncertain valueOf(const Surd<Uncertain>& s) {
    if (isExactlyZero(signOf(s.q, "")) || isExactlyZero(signOf(s.d, ""))) return s.p;
    return s.p + s.q * sqrt(s.d);
}

/// The sign of a - b. Numerically, as far as the inputs' rounding tells.
inline Decision compare(const Surd<Uncertain>& a, const Surd<Uncertain>& b, const char* what) {
    return signOf(valueOf(a) - valueOf(b), what);
}
/// Exactly: p + u sqrt(m) against v sqrt(n), squared once more if their signs are the same.
inline Decision compare(const Surd<Rational>& a, const Surd<Rational>& b, const char* what) {
    const Surd<Rational> left{a.p - b.p, a.q, a.d};
    const int l = signOf(left, what).sign, r = b.q.sign() * b.d.sign();
    Decision decision = signOf(Rational(0), what);
    decision.value = Real(a.p) - Real(b.p) + Real(a.q) * boost::multiprecision::sqrt(Real(a.d)) -
                     Real(b.q) * boost::multiprecision::sqrt(Real(b.d));
    if (l != r) {
        decision.sign = l > r ? 1 : -1;
        return decision;
    }
    const Surd<Rational> squares{left.p * left.p + left.q * left.q * left.d - b.q * b.q * b.d,
                                 2 * left.p * left.q, left.d};
    decision.sign = signOf(squares, what).sign * l;
    return decision;
}

} // namespace yarte::hard
