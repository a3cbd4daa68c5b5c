#include "yarte/scene/referential.h"

#include <gtest/gtest.h>

#include <cmath>

namespace yarte {
namespace {

constexpr Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};

double error(Vec3 a, Vec3 b) { return length(a - b); }

TEST(Referential, GoodAxes) {
    EXPECT_EQ(referentialError({x, y, {}}), std::nullopt);
    EXPECT_EQ(referentialError({x, y, z}), std::nullopt);
    EXPECT_EQ(referentialError({x, y, Vec3{}}), std::nullopt);
    EXPECT_EQ(referentialError({{1e300, 0, 0}, {0, 1e-300, 0}, {}}), std::nullopt);
    EXPECT_EQ(referentialError({{std::cos(9e-4), std::sin(9e-4), 0}, y, {}}), std::nullopt);
}

TEST(Referential, BadAxesAreToldWithTheirAngle) {
    EXPECT_EQ(referentialError({{}, y, {}}), "an axis of length 0 has no direction");
    EXPECT_EQ(referentialError({{1, 1, 0}, y, {}}),
              "axes x and y are not perpendicular: the angle between them is 45 degrees");
    EXPECT_EQ(referentialError({x, y, Vec3{0, 1, 1}}),
              "axes y and z are not perpendicular: the angle between them is 45 degrees");
    EXPECT_EQ(referentialError({x, y, Vec3{1, 0, 1}}),
              "axes x and z are not perpendicular: the angle between them is 45 degrees");
    EXPECT_EQ(referentialError({x, y, -z}), "axes are left-handed: z is at 180 degrees from x cross y");
    EXPECT_TRUE(referentialError({{std::cos(1.1e-3), std::sin(1.1e-3), 0}, y, {}}));
    EXPECT_TRUE(referentialError({x, x, {}}));
}

TEST(ResolveReferential, NormalisesAndCompletes) {
    const Frame f = resolveReferential({{0.707, 0.707, 0}, {-0.707, 0.707, 0}, Vec3{}});
    const double h = std::sqrt(0.5);
    EXPECT_LT(error(f.x, {h, h, 0}), 1e-15);
    EXPECT_LT(error(f.y, {-h, h, 0}), 1e-15);
    EXPECT_LT(error(f.z, z), 1e-15);
    EXPECT_EQ(resolveReferential({{2, 0, 0}, {0, 0, 1e-300}, {}}), (Frame{x, z, -y}));
}

TEST(ResolveReferential, RemovesSmallErrors) {
    const double e = 4e-4;
    const Frame f = resolveReferential({{std::cos(e), std::sin(e), 0}, {std::sin(e), std::cos(e), 0}, z});
    EXPECT_LT(error(f.x, x), 1e-15);
    EXPECT_LT(error(f.y, y), 1e-15);
}

} // namespace
} // namespace yarte
