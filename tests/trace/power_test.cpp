#include "yarte/trace/power.h"

#include "tests/support/scenes.h"

#include <gtest/gtest.h>

using namespace yarte;

namespace {

TEST(Power, KnownValues) {
    EXPECT_EQ(trace::power(1, 0), 1);
    EXPECT_EQ(trace::power(1, 1e6), 1);
    EXPECT_EQ(trace::power(0.5, 0), 1);
    EXPECT_EQ(trace::power(0.5, 1), 0.5);
    EXPECT_EQ(trace::power(0.5, 10), 0x1p-10);
    EXPECT_EQ(trace::power(0.1, 100), 0); // below e^-40
    EXPECT_EQ(trace::power(1e-300, 1), 0);
}

TEST(Power, AgreesWithTheLibraryInHigherPrecision) {
    test::Random random(7);
    for (int i = 0; i < 200000; ++i) {
        const double n = std::exp(random.between(-2, 14));
        const double x = std::exp(-random.between(0, 30) / n) * (1 + random.between(-1, 1) * 1e-16);
        if (!(x > 0)) continue;
        const long double exact = std::pow(static_cast<long double>(x), static_cast<long double>(n));
        // One rounding of the logarithm is multiplied by n ln x, at most 40.
        EXPECT_NEAR(static_cast<double>(trace::power(x, n) / exact), 1, 2e-14) << "x " << x << " n " << n;
    }
}

} // namespace
