#include "yarte/base/quantise.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace yarte {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(Quantiser, ClampsAndTakesNotANumberForBlack) {
    const Quantiser quantise(255, 2.2);
    EXPECT_EQ(quantise(-1), 0);
    EXPECT_EQ(quantise(-0.0), 0);
    EXPECT_EQ(quantise(-infinity), 0);
    EXPECT_EQ(quantise(nan), 0);
    EXPECT_EQ(quantise(1), 255);
    EXPECT_EQ(quantise(1.5), 255);
    EXPECT_EQ(quantise(infinity), 255);
}

TEST(Quantiser, WithoutGammaEveryStepIsHalfOpenAroundItsValue) {
    const Quantiser quantise(65535, 1);
    for (int k = 1; k < 65535; ++k) {
        EXPECT_EQ(quantise(k / 65535.0), k);
        EXPECT_EQ(quantise((k + 0.499) / 65535), k);
        EXPECT_EQ(quantise((k - 0.499) / 65535), k);
    }
}

TEST(Quantiser, GammaIsAppliedInFloatingPointAndRoundedOnce) {
    // 0.5^(1/2) = 0.70710678...: times 255 is 180.31, times 65535 is 46340.24.
    EXPECT_EQ(Quantiser(255, 2)(0.5), 180);
    EXPECT_EQ(Quantiser(65535, 2)(0.5), 46340);
    // Times 255 and 0.21763764^(1/2.2) = 0.5 is 127.5, the middle, which goes up; just below it goes down.
    EXPECT_EQ(Quantiser(255, 2.2)(std::pow(0.5, 2.2) * (1 + 1e-14)), 128);
    EXPECT_EQ(Quantiser(255, 2.2)(std::pow(0.5, 2.2) * (1 - 1e-14)), 127);
    // Gamma below 1 darkens: 0.5^2 * 255 = 63.75.
    EXPECT_EQ(Quantiser(255, 0.5)(0.5), 64);
}

TEST(Quantiser, IsTheFormulaOfTheManual) {
    const unsigned seed = std::random_device()();
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> unit(0, 1), gammas(0.3, 3);
    for (int i = 0; i < 100000; ++i) {
        const double v = unit(random) * unit(random), gamma = gammas(random);
        for (const int maximum : {255, 65535})
            ASSERT_EQ(Quantiser(maximum, gamma)(v), std::floor(maximum * std::pow(v, 1 / gamma) + 0.5))
                << v << ' ' << gamma;
    }
}

} // namespace
} // namespace yarte
