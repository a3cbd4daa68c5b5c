#include "validate/attribution_fit.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace yarte::validate {

namespace {

constexpr double relativeAllowance = 0.02;
/// Of a column's length, less is rounding: such a column is a sum of those before it.
constexpr double dependent = 1e-6;

using Vector = std::vector<double>;

double product(const Vector& a, const Vector& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
    return sum;
}

void subtract(Vector& from, const Vector& v, double factor) {
    for (std::size_t i = 0; i < from.size(); ++i) from[i] -= factor * v[i];
}

/// The factors that make sum(factor * column) closest to `target`, by modified Gram-Schmidt and back
/// substitution. A dependent column gets the factor 0.
Vector leastSquares(std::vector<Vector> columns, Vector target) {
    const std::size_t n = columns.size();
    std::vector<Vector> r(n, Vector(n));
    Vector projected(n);
    for (std::size_t j = 0; j < n; ++j) {
        const double before = std::sqrt(product(columns[j], columns[j]));
        for (std::size_t k = 0; k < j; ++k) {
            r[k][j] = product(columns[k], columns[j]);
            subtract(columns[j], columns[k], r[k][j]);
        }
        const double length = std::sqrt(product(columns[j], columns[j]));
        if (!(length > dependent * before)) {
            std::fill(columns[j].begin(), columns[j].end(), 0);
            continue;
        }
        r[j][j] = length;
        for (double& v : columns[j]) v /= length;
        projected[j] = product(columns[j], target);
        subtract(target, columns[j], projected[j]);
    }
    Vector factors(n);
    for (std::size_t j = n; j-- > 0;) {
        if (r[j][j] == 0) continue;
        double sum = projected[j];
        for (std::size_t k = j + 1; k < n; ++k) sum -= r[j][k] * factors[k];
        factors[j] = sum / r[j][j];
    }
    return factors;
}

double channel(Colour c, int i) { return i == 0 ? c.r : i == 1 ? c.g : c.b; }

double square(Colour c) { return c.r * c.r + c.g * c.g + c.b * c.b; }

/// `fit` with its factors, and what they leave over.
Fit judged(Fit fit, const Difference& difference, const std::vector<std::size_t>& pixels,
           const std::vector<Column>& columns) {
    std::size_t differing = 0, left = 0;
    double energy = 0, energyLeft = 0;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const Colour d = difference.at(pixels[i]);
        Colour model;
        for (std::size_t c = 0; c < columns.size(); ++c) model += fit.factors[c] * columns[c][i];
        differing += difference.differs(pixels[i]);
        left +=
            pixelError(d, model) > difference.threshold() + relativeAllowance * difference.error(pixels[i]);
        energy += square(d);
        energyLeft += square(d + -1.0 * model);
    }
    if (differing > 0) fit.leftover = static_cast<double>(left) / static_cast<double>(differing);
    if (energy > 0) fit.unexplained = energyLeft / energy;
    return fit;
}

} // namespace

Fit fitChannels(const Difference& difference, const std::vector<std::size_t>& pixels,
                const std::vector<Column>& columns) {
    std::vector<Vector> byChannel[3];
    Vector factors[3];
    for (int c = 0; c < 3; ++c) {
        for (const Column& column : columns) {
            Vector& values = byChannel[c].emplace_back();
            for (const Colour& colour : column) values.push_back(channel(colour, c));
        }
        Vector target;
        for (const std::size_t pixel : pixels) target.push_back(channel(difference.at(pixel), c));
        factors[c] = leastSquares(std::move(byChannel[c]), std::move(target));
    }
    Fit fit;
    for (std::size_t i = 0; i < columns.size(); ++i)
        fit.factors.push_back({factors[0][i], factors[1][i], factors[2][i]});
    return judged(std::move(fit), difference, pixels, columns);
}

Fit fitGrey(const Difference& difference, const std::vector<std::size_t>& pixels, const Column& column) {
    double both = 0, own = 0;
    for (std::size_t i = 0; i < pixels.size(); ++i)
        for (int c = 0; c < 3; ++c) {
            both += channel(difference.at(pixels[i]), c) * channel(column[i], c);
            own += channel(column[i], c) * channel(column[i], c);
        }
    const double k = own == 0 ? 0 : both / own;
    return judged({{{k, k, k}}, 1, 1}, difference, pixels, {column});
}

} // namespace yarte::validate
