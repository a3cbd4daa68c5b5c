#include "convert/povray/sdl/affine.h"

#include "tests/convert/povray/sdl/support.h"

#include <gtest/gtest.h>

#include <cmath>

namespace yarte::convert::povray::sdl::test {
namespace {

void expectNear(Vec3 a, Vec3 b, double tolerance = 1e-12) {
    EXPECT_NEAR(a.x, b.x, tolerance);
    EXPECT_NEAR(a.y, b.y, tolerance);
    EXPECT_NEAR(a.z, b.z, tolerance);
}

/// Measured: vrotate(x, 90*z) = y, vrotate(y, 90*x) = z, vrotate(z, 90*y) = x, vaxis_rotate(x, z, 90) = y.
TEST(Affine, TurnsAsPovrayDoes) {
    EXPECT_EQ(mapPoint(rotation({0, 0, 90}), {1, 0, 0}), (Vec3{0, 1, 0}));
    EXPECT_EQ(mapPoint(rotation({90, 0, 0}), {0, 1, 0}), (Vec3{0, 0, 1}));
    EXPECT_EQ(mapPoint(rotation({0, 90, 0}), {0, 0, 1}), (Vec3{1, 0, 0}));
    EXPECT_EQ(mapPoint(axisRotation({0, 0, 7}, 90), {1, 0, 0}), (Vec3{0, 1, 0}));
    // About x first, then y, then z.
    EXPECT_EQ(mapPoint(rotation({90, 90, 0}), {0, 1, 0}), (Vec3{1, 0, 0}));
    expectNear(mapPoint(rotation({0, 30, 0}), {0, 0, 2}), {1, 0, std::sqrt(3.0)});
    for (const Vec3 axis : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}})
        expectNear(mapPoint(rotation(axis * 33.0), {1, 2, 3}), mapPoint(axisRotation(axis, 33), {1, 2, 3}));
}

TEST(Affine, ComposesInTheOrderWritten) {
    const Affine a = then(scaling({2, 0, 3}), translation({1, 0, 0}));
    EXPECT_EQ(mapPoint(a, {1, 1, 1}), (Vec3{3, 1, 3})); // a scale of 0 is 1
    EXPECT_EQ(mapPoint(then(translation({1, 0, 0}), scaling({2, 1, 1})), {1, 1, 1}), (Vec3{4, 1, 1}));
    Random random(1);
    for (int i = 0; i < 100; ++i) {
        const Affine p = random.affine(), q = random.affine();
        const Vec3 v = random.inCube(3);
        expectNear(mapPoint(then(p, q), v), mapPoint(q, mapPoint(p, v)), 1e-11);
    }
}

TEST(Affine, InvertsWhatDoesNotFlatten) {
    Random random(2);
    for (int i = 0; i < 100; ++i) {
        const Affine a = random.affine();
        const Vec3 v = random.inCube(3);
        const auto back = inverse(a);
        ASSERT_TRUE(back);
        expectNear(mapPoint(*back, mapPoint(a, v)), v, 1e-10);
    }
    EXPECT_FALSE(inverse({{1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {}}));
    const auto tiny = inverse(scaling({1e-200, 1e-200, 1e-200}));
    ASSERT_TRUE(tiny);
    EXPECT_NEAR(tiny->x.x / 1e200, 1, 1e-12);
}

TEST(Affine, KeepsNormalsPerpendicularAndOnTheirSide) {
    Random random(3);
    for (int i = 0; i < 100; ++i) {
        const Affine a = random.affine();
        const Vec3 u = random.inCube(1), v = random.inCube(1), n = cross(u, v), inFront = n + u;
        const Vec3 mapped = mapNormal(a, n);
        EXPECT_NEAR(dot(mapped, mapDirection(a, u)), 0, 1e-12);
        EXPECT_NEAR(dot(mapped, mapDirection(a, v)), 0, 1e-12);
        EXPECT_GT(dot(mapped, mapDirection(a, inFront)), 0);
    }
}

TEST(Affine, IdentitiesChangeNoBit) {
    const Vec3 odd{-0.0, 0.1, -0.0};
    const auto same = [](Vec3 a, Vec3 b) { return a == b && std::signbit(a.x) == std::signbit(b.x); };
    EXPECT_TRUE(same(mapPoint({}, odd), odd));
    EXPECT_TRUE(same(mapPoint(translation(odd), {0, 0, 0}), odd));
    EXPECT_TRUE(same(then(Affine{}, translation(odd)).t, odd));
    EXPECT_TRUE(same(then(translation(odd), Affine{}).t, odd));
    const Affine turn{odd, {0.3, -0.0, 1}, odd, {}};
    EXPECT_TRUE(same(then(turn, translation({1, 2, 3})).x, odd));
    EXPECT_TRUE(same(then(translation({}), turn).z, odd));
}

} // namespace
} // namespace yarte::convert::povray::sdl::test
