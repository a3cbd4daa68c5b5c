#include "validate/judging.h"

#include "tests/validate/support.h"

#include <gmock/gmock.h>
#include <limits>

namespace yarte::validate {
namespace {

using test::constantPicture;

/// What the CaseError says, or "" if there was none.
std::string errorOf(const Picture& a, const Picture& b) {
    try {
        compare({"A", a}, {"B", b}, 0);
    } catch (const CaseError& error) {
        return error.what();
    }
    return "";
}

TEST(Compare, SizesThatDifferAreNamed) {
    EXPECT_EQ(errorOf(constantPicture(4, 2, {}), constantPicture(2, 4, {})),
              "sizes differ: A is 4x2, B is 2x4");
}

TEST(Compare, ValuesThatAreNotFiniteAreNamed) {
    Picture picture = constantPicture(4, 2, {});
    picture.pixels[5].b = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(errorOf(picture, constantPicture(4, 2, {})),
              "A has nan or infinity in 1 pixel, the first at (1, 1)");
    picture.pixels[6].b = std::numeric_limits<double>::infinity();
    EXPECT_EQ(errorOf(constantPicture(4, 2, {}), picture),
              "B has nan or infinity in 2 pixels, the first at (1, 1)");
}

TEST(Compare, EqualPicturesHaveNoErrorAtAll) {
    const Picture picture = constantPicture(5, 3, {0.25, 0.5, 0.75});
    const Comparison found = compare({"A", picture}, {"B", picture}, 0).numbers;
    EXPECT_EQ(found.maxAbs.value, 0);
    EXPECT_EQ(found.rmse, 0);
    EXPECT_EQ(found.psnr, std::nullopt);
    EXPECT_EQ(found.flip.max, 0);
    EXPECT_EQ(found.pixelsOver, 0u);
}

TEST(Compare, TheLimitIsFourSixteenBitSteps) {
    const Picture black = constantPicture(3, 1, {});
    Picture other = black;
    other.pixels[2].r = 4.0 / 65535;
    CaseReport report;
    report.width = 3;
    report.height = 1;
    judgeCase(report, {"A", other}, {"B", black}, {}, {});
    EXPECT_EQ(report.verdict, Verdict::pass);
    EXPECT_EQ(report.message, "");
    other.pixels[2].r = 4.001 / 65535;
    judgeCase(report, {"A", other}, {"B", black}, {}, {});
    EXPECT_EQ(report.verdict, Verdict::fail);
    EXPECT_EQ(report.message, "1 of 3 pixels differ by more than 6.104e-05, the most at (2, 0): 6.105e-05\n"
                              "max_abs <= 4/65535 does not hold: 6.105e-05, 1.00025 times the limit");
}

TEST(Compare, ExposureIsTheLargestPowerOfTwoThatAvoidsClipping) {
    EXPECT_EQ(exposureFor(0), 1);
    EXPECT_EQ(exposureFor(1), 1);
    EXPECT_EQ(exposureFor(1.0000001), 0.5);
    EXPECT_EQ(exposureFor(1.886), 0.5);
    EXPECT_EQ(exposureFor(2), 0.5);
    EXPECT_EQ(exposureFor(1000), 1.0 / 1024);
}

} // namespace
} // namespace yarte::validate
