#include "validate/metrics.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace yarte::validate {

namespace {

std::size_t pixelCount(ImageView image) {
    return static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
}

std::span<const Colour> pixels(ImageView image) { return {image.pixels, pixelCount(image)}; }

Pixel pixelAt(ImageView image, std::size_t index) {
    const auto width = static_cast<std::size_t>(image.width);
    return {static_cast<int>(index % width), static_cast<int>(index / width)};
}

bool isFinite(Colour c) { return std::isfinite(c.r) && std::isfinite(c.g) && std::isfinite(c.b); }

double squaredError(Colour a, Colour b) {
    const double r = a.r - b.r, g = a.g - b.g, bl = a.b - b.b;
    return r * r + g * g + bl * bl;
}

} // namespace

double pixelError(Colour a, Colour b) {
    return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
}

LargestError maxAbs(ImageView a, ImageView b) {
    double largest = -1;
    std::size_t at = 0;
    for (std::size_t i = 0; i < pixelCount(a); ++i)
        if (const double error = pixelError(a.pixels[i], b.pixels[i]); error > largest) {
            largest = error;
            at = i;
        }
    return {largest, pixelAt(a, at)};
}

double rmse(ImageView a, ImageView b) {
    double sum = 0;
    for (std::size_t i = 0; i < pixelCount(a); ++i) sum += squaredError(a.pixels[i], b.pixels[i]);
    return std::sqrt(sum / (3 * static_cast<double>(pixelCount(a))));
}

std::optional<double> psnr(double rmse) {
    if (rmse == 0) return std::nullopt;
    return -20 * std::log10(rmse);
}

std::size_t pixelsOver(ImageView a, ImageView b, double threshold) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < pixelCount(a); ++i) count += pixelError(a.pixels[i], b.pixels[i]) > threshold;
    return count;
}

NonFinite nonFinitePixels(ImageView image) {
    NonFinite found;
    for (std::size_t i = 0; i < pixelCount(image); ++i)
        if (!isFinite(image.pixels[i]) && found.count++ == 0) found.first = pixelAt(image, i);
    return found;
}

double maxValue(ImageView image) {
    double largest = maxComponent(image.pixels[0]);
    for (const Colour& colour : pixels(image)) largest = std::max(largest, maxComponent(colour));
    return largest;
}

} // namespace yarte::validate
