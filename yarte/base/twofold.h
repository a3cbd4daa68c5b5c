// Twofold: a number of twice a double's precision, as the unevaluated sum of two. For the few computations
// whose rounding would decide something.
#pragma once

#include "yarte/base/vec3.h"

#include <cmath>

namespace yarte {

/// high + low, |low| <= ulp(high) / 2. Results are good to a few times 2^-104, as long as nothing underflows
/// [Dekker 1971; Joldes, Muller, Popescu, "Tight and rigorous error bounds for basic building blocks of
/// double-word arithmetic", ACM TOMS 2017: algorithms 6, 11 and 17].
class Twofold {
public:
    constexpr Twofold(double value = 0) : high_(value) {}

    /// Exact.
    static Twofold sum(double a, double b) {
        const double s = a + b, bb = s - a;
        return {s, (a - (s - bb)) + (b - bb)};
    }
    static Twofold product(double a, double b) {
        const double p = a * b;
        return {p, std::fma(a, b, -p)};
    }

    /// The nearest double.
    double rounded() const { return high_; }

    friend Twofold operator-(Twofold a) { return {-a.high_, -a.low_}; }
    friend Twofold operator+(Twofold a, Twofold b) {
        Twofold s = sum(a.high_, b.high_);
        const Twofold t = sum(a.low_, b.low_);
        s = renormalised(s.high_, s.low_ + t.high_);
        return renormalised(s.high_, s.low_ + t.low_);
    }
    friend Twofold operator-(Twofold a, Twofold b) { return a + -b; }
    friend Twofold operator*(Twofold a, Twofold b) {
        const Twofold p = product(a.high_, b.high_);
        return renormalised(p.high_, p.low_ + (a.high_ * b.low_ + a.low_ * b.high_));
    }
    friend Twofold operator/(Twofold a, Twofold b) {
        const double q = a.high_ / b.high_;
        const Twofold rest = a - b * q;
        const double q2 = rest.high_ / b.high_;
        const Twofold rest2 = rest - b * q2;
        return renormalised(q, q2) + rest2.high_ / b.high_;
    }
    /// Of what is not negative.
    friend Twofold sqrt(Twofold a) {
        if (!(a.high_ > 0)) return 0;
        const double root = std::sqrt(a.high_);
        return Twofold(root) + (a - product(root, root)).high_ / (2 * root);
    }
    friend bool operator==(Twofold a, Twofold b) { return a.high_ == b.high_ && a.low_ == b.low_; }
    friend bool operator<(Twofold a, Twofold b) {
        return a.high_ < b.high_ || (a.high_ == b.high_ && a.low_ < b.low_);
    }
    friend bool operator>(Twofold a, Twofold b) { return b < a; }
    friend bool operator<=(Twofold a, Twofold b) { return !(b < a); }
    friend bool operator>=(Twofold a, Twofold b) { return !(a < b); }

private:
    constexpr Twofold(double high, double low) : high_(high), low_(low) {}
    /// Of |a| >= |b|.
    static Twofold renormalised(double a, double b) {
        const double s = a + b;
        return {s, b - (s - a)};
    }
    double high_, low_ = 0;
};

inline Twofold abs(Twofold a) { return a < 0 ? -a : a; }

struct Twofold3 {
    Twofold x, y, z;

    Twofold3() = default;
    Twofold3(Twofold a, Twofold b, Twofold c) : x(a), y(b), z(c) {}
    Twofold3(Vec3 v) : x(v.x), y(v.y), z(v.z) {}

    Vec3 rounded() const { return {x.rounded(), y.rounded(), z.rounded()}; }

    friend Twofold3 operator+(Twofold3 a, Twofold3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
    friend Twofold3 operator-(Twofold3 a, Twofold3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
    friend Twofold3 operator*(Twofold3 a, Twofold s) { return {a.x * s, a.y * s, a.z * s}; }
    friend Twofold dot(Twofold3 a, Twofold3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
    friend Twofold3 cross(Twofold3 a, Twofold3 b) {
        return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
    }
    friend Twofold3 normalised(Twofold3 a) { return a * (Twofold(1) / sqrt(dot(a, a))); }
};

/// The unit vector along `a`, which may be of any length but 0; rounded() gives components rounded once.
inline Twofold3 preciseUnitVector(Vec3 a) {
    int exponent; // scaled by a power of two, which rounds nothing, so that no square overflows
    std::frexp(std::max({std::abs(a.x), std::abs(a.y), std::abs(a.z)}), &exponent);
    const auto scaled = [&](double c) { return std::ldexp(c, -exponent); };
    return normalised(Twofold3(Vec3{scaled(a.x), scaled(a.y), scaled(a.z)}));
}

} // namespace yarte
