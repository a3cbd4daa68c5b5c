#include "validate/metrics.h"

#include "tests/validate/support.h"

#include <cmath>
#include <limits>

namespace yarte::validate {
namespace {

using test::constantPicture;

/// 2x2; differs from black by 0.5 in one channel and by 0.1, -0.2, 0.2 in another pixel.
Picture twoErrors() {
    Picture picture = constantPicture(2, 2, {});
    picture.pixels[1] = {0, 0.5, 0};
    picture.pixels[2] = {0.1, -0.2, 0.2};
    return picture;
}

TEST(Metrics, PixelErrorIsTheLargestOfTheChannels) {
    EXPECT_DOUBLE_EQ(pixelError({0.1, 0.2, 0.3}, {0.1, 0.5, 0.2}), 0.3);
    EXPECT_DOUBLE_EQ(pixelError({0, 0, 2}, {0, 0, -1}), 3);
}

TEST(Metrics, MaxAbsNamesTheFirstOfEqualPixels) {
    const Picture black = constantPicture(2, 2, {});
    Picture other = twoErrors();
    EXPECT_DOUBLE_EQ(maxAbs(other.view(), black.view()).value, 0.5);
    EXPECT_EQ(maxAbs(other.view(), black.view()).at, (Pixel{1, 0}));
    other.pixels[3] = {0.5, 0, 0};
    EXPECT_EQ(maxAbs(other.view(), black.view()).at, (Pixel{1, 0}));
    EXPECT_EQ(maxAbs(black.view(), black.view()).value, 0);
}

TEST(Metrics, RmseIsOverAllChannelsOfAllPixels) {
    // (0.25 + 0.01 + 0.04 + 0.04) / 12
    EXPECT_DOUBLE_EQ(rmse(twoErrors().view(), constantPicture(2, 2, {}).view()), std::sqrt(0.34 / 12));
}

TEST(Metrics, PsnrIsForThePeakOneAndMissingForEqualPictures) {
    EXPECT_DOUBLE_EQ(*psnr(0.1), 20);
    EXPECT_DOUBLE_EQ(*psnr(1), 0);
    EXPECT_EQ(psnr(0), std::nullopt);
}

TEST(Metrics, APixelOverTheThresholdCountsOnce) {
    const Picture black = constantPicture(2, 2, {});
    EXPECT_EQ(pixelsOver(twoErrors().view(), black.view(), 0.15), 2u);
    EXPECT_EQ(pixelsOver(twoErrors().view(), black.view(), 0.2), 1u)
        << "equal to the threshold is not over it";
    EXPECT_EQ(pixelsOver(twoErrors().view(), black.view(), 0.5), 0u);
}

TEST(Metrics, FindsNansAndInfinitiesOfBothSigns) {
    Picture picture = constantPicture(3, 2, {});
    EXPECT_EQ(nonFinitePixels(picture.view()).count, 0u);
    picture.pixels[2].g = std::numeric_limits<double>::quiet_NaN();
    picture.pixels[2].b = std::numeric_limits<double>::infinity();
    picture.pixels[4].r = -std::numeric_limits<double>::infinity();
    EXPECT_EQ(nonFinitePixels(picture.view()).count, 2u);
    EXPECT_EQ(nonFinitePixels(picture.view()).first, (Pixel{2, 0}));
}

TEST(Metrics, MaxValueIsThatOfAnyChannel) {
    EXPECT_EQ(maxValue(twoErrors().view()), 0.5);
    EXPECT_EQ(maxValue(constantPicture(1, 1, {-2, -1, -3}).view()), -1);
}

} // namespace
} // namespace yarte::validate
