#include "validate/flip.h"

#include "tests/validate/support.h"
#include "validate/flip_power.h"
#include "validate/image_file.h"

#include <cmath>
#include <gmock/gmock.h>
#include <random>

namespace yarte::validate {
namespace {

using test::constantPicture;

/// Constant pictures have no edges and survive the filters unchanged: their FLIP follows from the colour
/// pipeline alone.
void expectFlatFlip(Colour a, Colour b, double expected) {
    const FlipMap map = flipMap(constantPicture(40, 24, a).view(), constantPicture(40, 24, b).view());
    EXPECT_THAT(map.values, testing::Each(testing::FloatNear(static_cast<float>(expected), 2e-6f)));
}

TEST(Flip, FlatPicturesHaveThePublishedValues) {
    expectFlatFlip({0.1, 0.1, 0.1}, {0.9, 0.9, 0.9}, 0.951367);
    expectFlatFlip({0, 0, 0}, {1, 1, 1}, 0.967380);
    expectFlatFlip({0, 1, 0}, {0, 0, 1}, 1.000000);
    expectFlatFlip({0.5, 0.5, 0.5}, {0.51, 0.51, 0.51}, 0.040698);
    expectFlatFlip({1, 0, 0}, {0, 1, 0}, 0.986662);
}

TEST(Flip, ValuesOutsideTheRangeAreClamped) { expectFlatFlip({-3, -3, -3}, {7, 1, 2}, 0.967380); }

TEST(Flip, ThePublishedPairWithEdges) {
    const std::filesystem::path folder = std::filesystem::path(YARTE_CORPORA) / "flip";
    if (!std::filesystem::exists(folder)) GTEST_SKIP() << "skipped: YARTE_CORPORA has no flip";
    const Picture reference = readPicture(folder / "reference-crop.exr"),
                  test = readPicture(folder / "test-crop.exr");
    const FlipSummary found = summary(flipMap(reference.view(), test.view()));
    EXPECT_NEAR(found.mean, 0.309864, 5e-6);
    EXPECT_NEAR(found.max, 0.775379, 5e-6);
    EXPECT_EQ(found.maxAt, (Pixel{21, 146}));
}

Picture noise(int width, int height, unsigned seed) {
    std::mt19937 engine(seed);
    std::uniform_real_distribution<double> value;
    Picture picture = constantPicture(width, height, {});
    for (Colour& c : picture.pixels) c = {value(engine), value(engine), value(engine)};
    return picture;
}

Picture transposed(const Picture& picture) {
    Picture result{picture.height, picture.width, {}};
    for (int y = 0; y < result.height; ++y)
        for (int x = 0; x < result.width; ++x) result.pixels.push_back(picture.view().at(y, x));
    return result;
}

// The two directions go through different code, blocks and borders among them.
TEST(Flip, DoesNotDependOnTheDirection) {
    for (const auto& [width, height] : {std::pair(1, 1), {1, 40}, {15, 16}, {33, 7}, {50, 21}}) {
        const Picture a = noise(width, height, 1), b = noise(width, height, 2);
        const FlipMap map = flipMap(a.view(), b.view());
        const FlipMap turned = flipMap(transposed(a).view(), transposed(b).view());
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                ASSERT_NEAR(map.values[static_cast<std::size_t>(y * width + x)],
                            turned.values[static_cast<std::size_t>(x * height + y)], 2e-5)
                    << width << "x" << height << " at " << x << ", " << y;
    }
}

TEST(Flip, IsSymmetricAndInRange) {
    const Picture a = noise(37, 23, 3), b = noise(37, 23, 4);
    const FlipMap ab = flipMap(a.view(), b.view()), ba = flipMap(b.view(), a.view());
    EXPECT_EQ(ab.values, ba.values);
    EXPECT_THAT(ab.values, testing::Each(testing::AllOf(testing::Ge(0.0f), testing::Le(1.0f))));
}

TEST(Flip, PowersAreThoseOfTheStandardLibrary) {
    for (const double exponent : {1e-3, 0.1, 0.5, 0.7, 0.999, 1.0}) {
        for (double base = 1e-12; base < 1000; base *= 1.0007) {
            const double expected = std::pow(base, exponent);
            ASSERT_NEAR(flip::power(base, exponent), expected, 1e-8 * expected) << base << " " << exponent;
        }
        for (const double exact : {0.5, 1.0, 2.0, std::sqrt(0.5), std::sqrt(2.0)}) {
            const double expected = std::pow(exact, exponent);
            EXPECT_NEAR(flip::power(exact, exponent), expected, 1e-8 * expected);
        }
        EXPECT_EQ(flip::power(0, exponent), 0);
        EXPECT_EQ(flip::power(1, exponent), 1);
    }
}

// Taller than the rows that are kept, and shorter.
TEST(Flip, RowsFarAwayDoNotMatter) {
    const Picture a = noise(20, 70, 5), b = noise(20, 70, 6);
    const FlipMap whole = flipMap(a.view(), b.view());
    const auto strip = [](const Picture& p, int rows) {
        return Picture{p.width, rows, {p.pixels.begin(), p.pixels.begin() + p.width * rows}};
    };
    const Picture stripA = strip(a, 45), stripB = strip(b, 45);
    const FlipMap part = flipMap(stripA.view(), stripB.view());
    const auto seen = static_cast<std::ptrdiff_t>(20 * 30);
    EXPECT_TRUE(std::equal(part.values.begin(), part.values.begin() + seen, whole.values.begin()));
    EXPECT_NE(part.values.back(), whole.values[part.values.size() - 1]) << "here the edge is seen";
}

TEST(Flip, SummaryOfAMap) {
    const FlipSummary found = summary({2, 2, {0.0f, 0.5f, 0.75f, 0.75f}});
    EXPECT_DOUBLE_EQ(found.mean, 0.5);
    EXPECT_DOUBLE_EQ(found.max, 0.75);
    EXPECT_EQ(found.maxAt, (Pixel{0, 1}));
}

} // namespace
} // namespace yarte::validate
