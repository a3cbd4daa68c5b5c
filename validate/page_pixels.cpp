#include "validate/page_pixels.h"

#include "validate/display.h"
#include "validate/image_file.h"
#include "validate/samples.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace yarte::validate {

namespace {

constexpr double steps = 65535;
/// Finer than a file's rounding, and finer than the strictest tolerance; coarse enough that equal pictures
/// cost nothing.
constexpr double stepsShown = 1, partsOfAStep = 4;
constexpr int thumbnailSide = 96;

using Channels = std::array<double, 3>;

Channels channels(Colour c) { return {c.r, c.g, c.b}; }

/// Calls `visit(x, y)` for the pixels of a square that lie in the picture.
template <class Visit>
void forSquare(ImageView image, int column, int row, int side, const Visit& visit) {
    for (int y = row * side; y < std::min((row + 1) * side, image.height); ++y)
        for (int x = column * side; x < std::min((column + 1) * side, image.width); ++x) visit(x, y);
}

constexpr int reduced(int length, int side) { return (length + side - 1) / side; }

/// `image` with squares of `side` pixels become one, their mean.
Picture reducedPicture(ImageView image, int side) {
    Picture small{reduced(image.width, side), reduced(image.height, side), {}};
    for (int row = 0; row < small.height; ++row)
        for (int column = 0; column < small.width; ++column) {
            Colour sum;
            int count = 0;
            forSquare(image, column, row, side, [&](int x, int y) {
                sum = sum + image.at(x, y);
                ++count;
            });
            small.pixels.push_back(sum * (1.0 / count));
        }
    return small;
}

/// Makes the range of the samples hold all values: at least [0, 1].
void widenRange(PagePixels& page, ImageView image) {
    const std::size_t count = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    double low = page.offset, high = page.offset + page.unit;
    for (std::size_t i = 0; i < count; ++i)
        for (const double v : channels(image.pixels[i])) {
            low = std::min(low, v);
            high = std::max(high, v);
        }
    page.offset = low;
    page.unit = high - low;
}

std::int32_t rounded(double v) { return static_cast<std::int32_t>(std::lround(v)); }

std::string packReference(ImageView b, const PagePixels& page) {
    Samples samples{b.width, b.height, 3, {}};
    for (int y = 0; y < b.height; ++y)
        for (int x = 0; x < b.width; ++x)
            for (const double v : channels(b.at(x, y)))
                samples.values.push_back(rounded((v - page.offset) / page.unit * steps));
    return pack(samples);
}

std::string packDifference(ImageView a, ImageView b, const PagePixels& page) {
    Samples samples{page.width, page.height, 3, {}};
    for (int row = 0; row < page.height; ++row)
        for (int column = 0; column < page.width; ++column) {
            Channels largest{};
            forSquare(a, column, row, page.reduction, [&](int x, int y) {
                const Channels va = channels(a.at(x, y)), vb = channels(b.at(x, y));
                for (std::size_t c = 0; c < 3; ++c)
                    if (std::abs(va[c] - vb[c]) > std::abs(largest[c])) largest[c] = va[c] - vb[c];
            });
            for (const double d : largest) {
                const double inSteps = d / page.unit * steps;
                const double parts = std::abs(inSteps) < stepsShown ? 0 : inSteps * partsOfAStep;
                samples.values.push_back(rounded(parts));
            }
        }
    return pack(samples);
}

std::string packFlip(const FlipMap& flip, const PagePixels& page) {
    Samples samples{page.width, page.height, 1, {}};
    const ImageView size{flip.width, flip.height, nullptr};
    for (int row = 0; row < page.height; ++row)
        for (int column = 0; column < page.width; ++column) {
            float largest = 0;
            forSquare(size, column, row, page.reduction, [&](int x, int y) {
                largest = std::max(
                    largest, flip.values[static_cast<std::size_t>(y) * static_cast<std::size_t>(flip.width) +
                                         static_cast<std::size_t>(x)]);
            });
            samples.values.push_back(rounded(255.0 * static_cast<double>(largest)));
        }
    return pack(samples);
}

std::string thumbnailOf(ImageView image) {
    const int side = reduced(std::max(image.width, image.height), thumbnailSide);
    return encodePng(displayPicture(reducedPicture(image, side).view()));
}

/// Packs `reference`, and by `packRest` the rest, with the smallest reduction that keeps the limit.
template <class PackRest>
void packWithin(std::size_t limit, PagePixels& page, ImageView reference, const PackRest& packRest) {
    for (;; page.reduction *= 2) {
        const Picture small = reducedPicture(reference, page.reduction);
        page.width = small.width;
        page.height = small.height;
        page.reference = packReference(small.view(), page);
        packRest();
        if (page.reference.size() + page.difference.size() + page.flip.size() <= limit) return;
        if (page.width == 1 && page.height == 1) return;
    }
}

} // namespace

PagePixels pagePixels(ImageView a, ImageView b, const FlipMap& flip, std::size_t limit) {
    PagePixels page;
    widenRange(page, a);
    widenRange(page, b);
    page.thumbnail = thumbnailOf(a);
    packWithin(limit, page, b, [&] {
        page.difference = packDifference(a, b, page);
        page.flip = packFlip(flip, page);
    });
    return page;
}

PagePixels pagePixels(ImageView image, std::size_t limit) {
    PagePixels page;
    widenRange(page, image);
    page.thumbnail = thumbnailOf(image);
    packWithin(limit, page, image, [] {});
    return page;
}

} // namespace yarte::validate
