#include "yarte/trace/camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

using namespace yarte;
using namespace yarte::trace;

namespace {

void expectNear(Vec3 a, Vec3 b, double tolerance) {
    EXPECT_NEAR(a.x, b.x, tolerance);
    EXPECT_NEAR(a.y, b.y, tolerance);
    EXPECT_NEAR(a.z, b.z, tolerance);
}

TEST(Camera, LooksThroughPixelCentresWithRowZeroOnTop) {
    const CameraRays rays({{0, 0, 5}, {0, 0, 0}, {0, 1, 0}, 45, 45}, {2, 2});
    expectNear(rays.through(0, 0).direction, normalised(Vec3{-0.5, 0.5, -1}), 1e-15);
    expectNear(rays.through(1, 0).direction, normalised(Vec3{0.5, 0.5, -1}), 1e-15);
    expectNear(rays.through(0, 1).direction, normalised(Vec3{-0.5, -0.5, -1}), 1e-15);
}

TEST(Camera, AperturesAreHalfAnglesFromTheAxis) {
    const CameraRays rays({{}, {0, 0, -1}, {0, 1, 0}, 30, 10}, {1, 1});
    const auto angle = [&](Vec3 edge) {
        return std::acos(dot(normalised(edge), rays.forward)) * 180 / std::numbers::pi;
    };
    EXPECT_NEAR(angle(rays.forward + rays.right / 2), 30, 1e-12);
    EXPECT_NEAR(angle(rays.forward + rays.up / 2), 10, 1e-12);
}

TEST(Camera, UpNeedNotBePerpendicular) {
    const Camera straight{{1, 2, 3}, {4, 6, 3}, {0, 0, 1}, 20, 20};
    Camera tilted = straight;
    tilted.up = Vec3{0, 0, 1} + 0.7 * (straight.focus - straight.position);
    const CameraRays a(straight, {7, 5}), b(tilted, {7, 5});
    for (int y = 0; y < 5; ++y)
        for (int x = 0; x < 7; ++x) expectNear(a.through(x, y).direction, b.through(x, y).direction, 1e-14);
}

TEST(Camera, DirectionsAreUnit) {
    const CameraRays rays({{1e6, -3, 2}, {-5, 1e5, 8}, {0.1, 1, 0}, 80, 5}, {31, 17});
    for (int y = 0; y < 17; ++y)
        for (int x = 0; x < 31; ++x) EXPECT_NEAR(length(rays.through(x, y).direction), 1, 3e-16);
}

} // namespace
