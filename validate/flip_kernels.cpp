#include "validate/flip_kernels.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace yarte::validate::flip {

namespace {

constexpr double pi = std::numbers::pi;

/// f at 0 ... radius.
template <class F>
std::vector<double> sampled(int radius, const F& f) {
    std::vector<double> weights;
    for (int x = 0; x <= radius; ++x) weights.push_back(f(x));
    return weights;
}

/// The sum over both sides of an even kernel.
double evenSum(const std::vector<double>& weights) {
    double sum = weights[0];
    for (std::size_t k = 1; k < weights.size(); ++k) sum += 2 * weights[k];
    return sum;
}

Kernel scaledKernel(Kernel::Kind kind, const std::vector<double>& weights, double factor) {
    Kernel kernel{kind, {}};
    for (const double weight : weights) kernel.weights.push_back(static_cast<float>(factor * weight));
    return kernel;
}

/// The sum of all weights becomes `sum`; the tail that a sum of floats cannot feel is cut off.
Kernel evenKernel(const std::vector<double>& weights, double sum = 1) {
    constexpr float negligible = 1e-9f;
    Kernel kernel = scaledKernel(Kernel::Kind::even, weights, sum / evenSum(weights));
    while (kernel.weights.size() > 1 && kernel.weights.back() < negligible) kernel.weights.pop_back();
    return kernel;
}

/// Each side of an odd kernel sums to 1 or -1.
Kernel oddKernel(const std::vector<double>& weights) {
    double side = 0;
    for (const double weight : weights) side += std::abs(weight);
    return scaledKernel(Kernel::Kind::odd, weights, 1 / side);
}

/// The positive weights sum to 1 and the negative ones to -1.
Kernel curvatureKernel(std::vector<double> weights) {
    double positive = 0, negative = 0;
    for (std::size_t k = 0; k < weights.size(); ++k)
        (weights[k] > 0 ? positive : negative) += (k == 0 ? 1 : 2) * std::abs(weights[k]);
    for (double& weight : weights) weight /= weight > 0 ? positive : negative;
    return scaledKernel(Kernel::Kind::curvature, weights, 1);
}

} // namespace

Kernels::Kernels(double pixelsPerDegree) {
    // Contrast sensitivity, table 1: a sqrt(pi/b) e^(-pi^2 x^2 / b), x in degrees.
    constexpr double widest = 0.04;
    const int radius = static_cast<int>(std::ceil(3 * std::sqrt(widest / (2 * pi * pi)) * pixelsPerDegree));
    const auto contrast = [&](double b) {
        return sampled(radius, [&](double x) {
            const double degrees = x / pixelsPerDegree;
            return std::exp(-pi * pi * degrees * degrees / b);
        });
    };
    luminance = evenKernel(contrast(0.0047));
    redGreen = evenKernel(contrast(0.0053));

    const double a[] = {34.1, 13.5}, b[] = {widest, 0.025};
    double volume[2];
    for (int i = 0; i < 2; ++i)
        volume[i] = a[i] * std::sqrt(pi / b[i]) * std::pow(evenSum(contrast(b[i])), 2);
    for (int i = 0; i < 2; ++i) {
        blueYellow[i] = evenKernel(contrast(b[i]));
        blueYellowWeighted[i] = evenKernel(contrast(b[i]), volume[i] / (volume[0] + volume[1]));
    }

    // Features: the eye sees edges that are 0.082 degrees wide.
    const double sigma = 0.5 * 0.082 * pixelsPerDegree;
    const int featureRadius = static_cast<int>(std::ceil(3 * sigma));
    const auto bell = [&](double x) { return std::exp(-x * x / (2 * sigma * sigma)); };
    gauss = evenKernel(sampled(featureRadius, bell));
    edge = oddKernel(sampled(featureRadius, [&](double x) { return x * bell(x); }));
    point = curvatureKernel(
        sampled(featureRadius, [&](double x) { return (x * x / (sigma * sigma) - 1) * bell(x); }));
    maxRadius = static_cast<std::size_t>(std::max(radius, featureRadius));
}

} // namespace yarte::validate::flip
