#include "validate/page_pixels.h"

#include "tests/validate/support.h"
#include "validate/samples.h"

namespace yarte::validate {
namespace {

using test::constantPicture;

constexpr std::size_t noLimit = 1 << 30;
constexpr double step = 1.0 / 65535;

std::string packed(int width, int height, int channels, std::vector<std::int32_t> values) {
    return pack({width, height, channels, std::move(values)});
}

FlipMap noFlip(const Picture& picture) {
    return {picture.width, picture.height, std::vector<float>(picture.pixels.size())};
}

TEST(PagePixels, KeepStepsOfTheReferenceAndQuartersOfTheDifference) {
    const Picture b = constantPicture(2, 1, {0, 0.5, 1});
    Picture a = b;
    a.pixels[0] = {0.9 * step, 0.5 + 1.26 * step, 1 - 300 * step};
    FlipMap flip = noFlip(b);
    flip.values = {0.5f, 0};
    const PagePixels page = pagePixels(a.view(), b.view(), flip, noLimit);
    EXPECT_EQ(page.reduction, 1);
    EXPECT_EQ(page.unit, 1);
    EXPECT_EQ(page.offset, 0);
    EXPECT_EQ(page.reference, packed(2, 1, 3, {0, 32768, 65535, 0, 32768, 65535}));
    EXPECT_EQ(page.difference, packed(2, 1, 3, {0, 5, -1200, 0, 0, 0})) << "less than a step is 0";
    EXPECT_EQ(page.flip, packed(2, 1, 1, {128, 0}));
    EXPECT_EQ(page.thumbnail.substr(1, 3), "PNG");
}

TEST(PagePixels, TheRangeOfBothPicturesFits) {
    const Picture b = constantPicture(1, 1, {0, 3, 0}), a = constantPicture(1, 1, {-1, 3, 0});
    const PagePixels page = pagePixels(a.view(), b.view(), noFlip(b), noLimit);
    EXPECT_EQ(page.offset, -1);
    EXPECT_EQ(page.unit, 4);
    EXPECT_EQ(page.reference, packed(1, 1, 3, {16384, 65535, 16384}));
    EXPECT_EQ(page.difference, packed(1, 1, 3, {-65535, 0, 0}));
}

TEST(PagePixels, WhatIsTooLargeIsReducedButNoErrorIsLost) {
    const Picture b = constantPicture(65, 64, {0.5, 0.5, 0.5});
    Picture a = b;
    a.pixels[17].g += 0.25;
    const PagePixels page = pagePixels(a.view(), b.view(), noFlip(b), 1);
    EXPECT_EQ(page.width, 1);
    EXPECT_EQ(page.height, 1);
    EXPECT_EQ(page.reduction, 128);
    EXPECT_EQ(page.reference, packed(1, 1, 3, {32768, 32768, 32768}));
    EXPECT_EQ(page.difference, packed(1, 1, 3, {0, 65535, 0})) << "0.25 in quarters of a step";
    const PagePixels whole = pagePixels(a.view(), b.view(), noFlip(b), noLimit);
    const std::size_t size = whole.reference.size() + whole.difference.size() + whole.flip.size();
    EXPECT_EQ(pagePixels(a.view(), b.view(), noFlip(b), size).reduction, 1);
    EXPECT_EQ(pagePixels(a.view(), b.view(), noFlip(b), size - 1).reduction, 2);
}

TEST(PagePixels, OfOnePicture) {
    const PagePixels page = pagePixels(constantPicture(3, 2, {1, 1, 1}).view(), noLimit);
    EXPECT_EQ(page.width, 3);
    EXPECT_EQ(page.difference, "");
    EXPECT_EQ(page.flip, "");
}

} // namespace
} // namespace yarte::validate
