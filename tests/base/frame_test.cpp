#include "yarte/base/frame.h"

#include <gtest/gtest.h>

#include <random>

namespace yarte {
namespace {

double distance(const Frame& a, const Frame& b) {
    return length(a.x - b.x) + length(a.y - b.y) + length(a.z - b.z);
}

void expectRotation(const Frame& f) {
    EXPECT_NEAR(length(f.x), 1, 1e-15);
    EXPECT_NEAR(length(f.y), 1, 1e-15);
    EXPECT_NEAR(length(f.z), 1, 1e-15);
    EXPECT_NEAR(dot(f.x, f.y), 0, 1e-15);
    EXPECT_NEAR(dot(f.y, f.z), 0, 1e-15);
    EXPECT_NEAR(dot(f.z, f.x), 0, 1e-15);
    EXPECT_NEAR(dot(cross(f.x, f.y), f.z), 1, 1e-15);
}

TEST(Frame, LocalAndWorldAreInverse) {
    const Frame f{{0, 1, 0}, {0, 0, 1}, {1, 0, 0}};
    EXPECT_EQ(f.toWorld({1, 2, 3}), (Vec3{3, 1, 2}));
    EXPECT_EQ(f.toLocal({3, 1, 2}), (Vec3{1, 2, 3}));
}

TEST(ClosestRotation, LeavesARotationAsItIs) {
    EXPECT_EQ(closestRotation({1, 0, 0}, {0, 1, 0}, {0, 0, 1}), Frame{});
    EXPECT_EQ(closestRotation({0, 1, 0}, {-1, 0, 0}, {0, 0, 1}), (Frame{{0, 1, 0}, {-1, 0, 0}, {0, 0, 1}}));
}

TEST(ClosestRotation, SharesASymmetricErrorEvenly) {
    // x and y lean towards each other by the same angle: the rotation in the middle turns neither way.
    const double e = 1e-3;
    const Frame f = closestRotation({std::cos(e), std::sin(e), 0}, {std::sin(e), std::cos(e), 0}, {0, 0, 1});
    expectRotation(f);
    EXPECT_LT(distance(f, Frame{}), 1e-15);
}

TEST(ClosestRotation, NoOtherRotationIsCloser) {
    constexpr unsigned seed = 7;
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> small(-1e-3, 1e-3);
    const auto vector = [&] { return Vec3{small(random), small(random), small(random)}; };
    for (int i = 0; i < 200; ++i) {
        const Vec3 x = Vec3{1, 0, 0} + vector(), y = Vec3{0, 1, 0} + vector(), z = Vec3{0, 0, 1} + vector();
        const Frame f = closestRotation(x, y, z);
        expectRotation(f);
        const auto squares = [&](const Frame& q) {
            return dot(q.x - x, q.x - x) + dot(q.y - y, q.y - y) + dot(q.z - z, q.z - z);
        };
        for (const Vec3 axis : {f.x, f.y, f.z})
            for (const double angle : {-1e-4, 1e-4}) {
                const auto turned = [&](Vec3 v) {
                    return v * std::cos(angle) + cross(axis, v) * std::sin(angle) +
                           axis * (dot(axis, v) * (1 - std::cos(angle)));
                };
                EXPECT_GT(squares({turned(f.x), turned(f.y), turned(f.z)}), squares(f)) << "seed " << seed;
            }
    }
}

} // namespace
} // namespace yarte
