// power in float, which has no scalar form to be compared with.
#include "tests/support/scenes.h"

#include <hwy/highway.h>

#define YARTE_PRECISION inFloat
#include "yarte/trace/lanes/power-inl.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace yarte;

namespace {

namespace lanes = trace::HWY_NAMESPACE::inFloat;

float power(float x, float n) {
    return hwy::HWY_NAMESPACE::GetLane(lanes::power(lanes::set(x), lanes::set(n)));
}

TEST(PowerInFloat, KnownValues) {
    EXPECT_EQ(power(1, 0), 1);
    EXPECT_EQ(power(1, 1e6f), 1);
    EXPECT_EQ(power(0.5f, 0), 1);
    EXPECT_EQ(power(0.5f, 1), 0.5f);
    EXPECT_EQ(power(0.5f, 10), 0x1p-10f);
    EXPECT_EQ(power(0.1f, 100), 0); // below e^-40
    EXPECT_EQ(power(1e-30f, 1), 0);
}

TEST(PowerInFloat, AgreesWithTheLibrary) {
    test::Random random(7);
    for (int i = 0; i < 200000; ++i) {
        const float n = static_cast<float>(std::exp(random.between(-2, 14)));
        const float x = static_cast<float>(std::exp(-random.between(0, 30) / n));
        if (x < std::numeric_limits<float>::min()) continue;
        // One rounding of the logarithm is multiplied by n ln x, at most 40.
        EXPECT_NEAR(power(x, n) / std::pow(double{x}, double{n}), 1, 1e-5) << "x " << x << " n " << n;
    }
}

} // namespace
