#include "convert/povray/sdl/spline.h"

#include "convert/povray/sdl/interpreter.h"

#include <algorithm>

namespace yarte::convert::povray::sdl {
namespace {

using Points = std::vector<Spline::Point>;

/// Which formula each kind follows was found by comparing with what POV-Ray prints.
double linear(const Points& p, std::size_t i, std::size_t c, double at) {
    const double u = (at - p[i].at) / (p[i + 1].at - p[i].at);
    return p[i].value.at[c] * (1 - u) + p[i + 1].value.at[c] * u;
}

/// The parabola through the segment's ends and the point before it; for the first one, the point after it.
double quadratic(const Points& p, std::size_t i, std::size_t c, double at) {
    const std::size_t first = i == 0 ? 0 : i - 1;
    double sum = 0;
    for (std::size_t j = first; j < first + 3; ++j) {
        double weight = 1;
        for (std::size_t k = first; k < first + 3; ++k)
            if (k != j) weight *= (at - p[k].at) / (p[j].at - p[k].at);
        sum += weight * p[j].value.at[c];
    }
    return sum;
}

/// Hermite's cubic, its slope at a point the mean of those to the neighbours.
double cubic(const Points& p, std::size_t i, std::size_t c, double at) {
    const double h = p[i + 1].at - p[i].at, u = (at - p[i].at) / h;
    const auto secant = [&](std::size_t j) {
        return (p[j + 1].value.at[c] - p[j].value.at[c]) / (p[j + 1].at - p[j].at);
    };
    const auto slope = [&](std::size_t j) { return (secant(j - 1) + secant(j)) / 2; };
    return (1 + 2 * u) * (1 - u) * (1 - u) * p[i].value.at[c] + u * (1 - u) * (1 - u) * h * slope(i) +
           u * u * (3 - 2 * u) * p[i + 1].value.at[c] + u * u * (u - 1) * h * slope(i + 1);
}

/// Second derivatives at the points of the curve with none at its ends, by the tridiagonal system.
std::vector<double> curvatures(const Points& p, std::size_t c) {
    const std::size_t n = p.size();
    std::vector<double> second(n), upper(n);
    for (std::size_t i = 1; i + 1 < n; ++i) {
        const double before = p[i].at - p[i - 1].at, after = p[i + 1].at - p[i].at;
        const double right = 6 * ((p[i + 1].value.at[c] - p[i].value.at[c]) / after -
                                  (p[i].value.at[c] - p[i - 1].value.at[c]) / before);
        const double pivot = 2 * (before + after) - before * upper[i - 1];
        upper[i] = after / pivot;
        second[i] = (right - before * second[i - 1]) / pivot;
    }
    for (std::size_t i = n - 1; i-- > 1;) second[i] -= upper[i] * second[i + 1];
    return second;
}

double natural(const Points& p, std::size_t i, std::size_t c, double at) {
    const std::vector<double> second = curvatures(p, c);
    const double h = p[i + 1].at - p[i].at, b = (at - p[i].at) / h, a = 1 - b;
    return a * p[i].value.at[c] + b * p[i + 1].value.at[c] +
           ((a * a * a - a) * second[i] + (b * b * b - b) * second[i + 1]) * h * h / 6;
}

} // namespace

std::optional<SplineKind> splineKind(Interpreter& in) {
    if (in.accept("linear_spline")) return SplineKind::linear;
    if (in.accept("quadratic_spline")) return SplineKind::quadratic;
    if (in.accept("natural_spline")) return SplineKind::natural;
    if (in.accept("cubic_spline")) return SplineKind::cubic;
    return std::nullopt;
}

Value parseSpline(Interpreter& in) {
    in.next();
    in.expect('{');
    auto spline = std::make_shared<Spline>();
    if (auto base = in.acceptNamed<Shared<Spline>>()) *spline = **base;
    spline->kind = splineKind(in).value_or(spline->kind);
    while (!in.accept('}')) {
        const double at = in.number();
        in.comma();
        const Vector value = in.expression();
        in.comma();
        const auto place = std::ranges::lower_bound(spline->points, at, {}, &Spline::Point::at);
        if (place != spline->points.end() && place->at == at)
            place->value = value;
        else
            spline->points.insert(place, {at, value});
    }
    return Shared<Spline>(spline);
}

Vector evaluate(const Spline& spline, double at, SplineKind kind) {
    const Points& p = spline.points;
    if (p.empty()) return Vector::number(0);
    if (kind == SplineKind::quadratic && p.size() < 3) kind = SplineKind::linear;
    if (kind == SplineKind::cubic && p.size() < 4) kind = SplineKind::linear;
    // A cubic one needs a neighbour at each end.
    const std::size_t margin = kind == SplineKind::cubic ? 1 : 0;
    const std::size_t first = margin, last = p.size() - 1 - margin;
    int size = 1;
    for (const auto& point : p) size = std::max(size, point.value.size);
    if (!(at > p[first].at)) return p[first].value.promoted(size);
    if (!(at < p[last].at)) return p[last].value.promoted(size);
    const auto next = std::ranges::upper_bound(p, at, {}, &Spline::Point::at);
    const std::size_t i = static_cast<std::size_t>(next - p.begin()) - 1;
    Vector result{size, {}};
    for (std::size_t c = 0; c < static_cast<std::size_t>(size); ++c) switch (kind) {
        case SplineKind::linear: result.at[c] = linear(p, i, c, at); break;
        case SplineKind::quadratic: result.at[c] = quadratic(p, i, c, at); break;
        case SplineKind::natural: result.at[c] = natural(p, i, c, at); break;
        case SplineKind::cubic: result.at[c] = cubic(p, i, c, at); break;
        }
    return result;
}

} // namespace yarte::convert::povray::sdl
