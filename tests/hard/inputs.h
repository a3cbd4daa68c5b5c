// Inputs: the doubles that a truth depends on, as exact numbers or as numbers that may be off by half an ulp.
//
// They are the numbers of the scene and of the ray as they are written. Directions are written in any length:
// of a plane's normal and of an object's axes the truth takes the exact unit vectors (of axes the closest
// rotation), and their components count as inputs, since a tracer in doubles can hold no more than them,
// rounded.
#pragma once

#include "tests/hard/uncertain.h"
#include "yarte/base/vec3.h"
#include "yarte/scene/shapes.h"

#include <optional>

namespace yarte::hard {

template <class N>
struct Axes {
    Vec<N> x, y, z;
};

/// The exact rotation closest to the axes as written, by Newton's iteration for the polar factor.
Axes<Real> exactRotation(const Referential&);
Vec<Real> exactUnit(const Vec3&);

template <class N>
class Inputs;

template <>
class Inputs<Rational> {
public:
    Rational number(double x) { return Rational(x); }
    Rational number(const Real& x) { return Rational(x); }
};

template <>
class Inputs<Uncertain> {
public:
    Uncertain number(double x) { return make(Real(x), x); }
    /// Rounded to a double somewhere.
    Uncertain number(const Real& x) { return make(x, static_cast<double>(x)); }

    /// The sum over the inputs of |df/dx x|.
    double sensitivity(const Uncertain& f) const {
        double sum = 0;
        for (const Uncertain::Share& s : f.shares()) sum += std::abs(s.change) * inHalfUlps_[s.input];
        return sum;
    }

private:
    Uncertain make(const Real& value, double rounded) {
        const double half = halfUlp(rounded);
        if (half == 0) return Uncertain(value);
        inHalfUlps_.push_back(std::abs(rounded) / half);
        return {value, static_cast<std::uint32_t>(inHalfUlps_.size() - 1), half};
    }
    std::vector<double> inHalfUlps_; ///< |x| of each input
};

template <class N>
Vec<N> vectorOf(Inputs<N>& inputs, const Vec3& v) {
    return {inputs.number(v.x), inputs.number(v.y), inputs.number(v.z)};
}
template <class N>
Vec<N> vectorOf(Inputs<N>& inputs, const Vec<Real>& v) {
    return {inputs.number(v.x), inputs.number(v.y), inputs.number(v.z)};
}
/// None: the axes of the world.
template <class N>
std::optional<Axes<N>> axesOf(Inputs<N>& inputs, const std::optional<Referential>& referential) {
    if (!referential) return std::nullopt;
    const Axes<Real> exact = exactRotation(*referential);
    return Axes<N>{vectorOf(inputs, exact.x), vectorOf(inputs, exact.y), vectorOf(inputs, exact.z)};
}

} // namespace yarte::hard
