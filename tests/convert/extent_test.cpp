// The world scale for POV-Ray.
#include "convert/povray/extent.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace yarte::convert::povray {
namespace {

TEST(WorldScale, IsSmallerWithPlanes) {
    Scene scene;
    scene.camera.position = {0, 6, 0};
    scene.bodies.push_back({Sphere{{0, 0, 0}, 1}, {}, {}, {}});
    EXPECT_EQ(extentOf(scene), 7);
    EXPECT_EQ(worldScaleOf(scene), 16384);
    scene.bodies.push_back({Plane{{0, 2, 0}, -4}, {}, {}, {}}); // the point below the camera counts
    EXPECT_EQ(extentOf(scene), 10);
    EXPECT_EQ(worldScaleOf(scene), 32);
}

TEST(WorldScale, IsAPowerOfTwoThatBringsTheExtentToAHundredThousand) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> exponent(-12, 12);
    for (int i = 0; i < 1000; ++i) {
        const double extent = std::pow(10, exponent(random)), scale = worldScaleFor(extent);
        int power = 0;
        EXPECT_EQ(std::frexp(scale, &power), 0.5) << extent;
        EXPECT_GE(extent * scale, 1e5 * (1 - 1e-12)) << extent;
        EXPECT_LT(extent * scale, 2e5 * (1 + 1e-12)) << extent;
    }
}

TEST(WorldScale, IsOneWhereThereIsNoExtent) {
    EXPECT_EQ(worldScaleFor(0), 1);
    EXPECT_EQ(worldScaleFor(-1), 1);
    EXPECT_EQ(worldScaleFor(std::numeric_limits<double>::infinity()), 1);
    EXPECT_EQ(worldScaleFor(std::numeric_limits<double>::quiet_NaN()), 1);
    EXPECT_EQ(worldScaleFor(std::numeric_limits<double>::denorm_min()), std::exp2(1000));
}

TEST(Extent, HoldsCameraLightsAndBodies) {
    Scene scene;
    scene.camera.position = {0, 0, 5};
    EXPECT_EQ(extentOf(scene), 0);
    scene.lights.push_back({{0, 7, 0}, {1, 1, 1}});
    EXPECT_EQ(extentOf(scene), 7);
    scene.bodies.push_back({Sphere{{-10, 0, 0}, 2}, {}, {}, {}});
    EXPECT_EQ(extentOf(scene), 12);
    scene.lights.push_back({{0, 1e6, 0}, {1, 1, 1}}); // only a direction
    EXPECT_EQ(extentOf(scene), 12);
    scene.meshes.push_back({"m", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {0, 3}, {0, 1, 2}, {}, {}});
    scene.bodies.push_back({Mesh{{0}, 100, {}, {0, 0, 1}}, {}, {}, {}});
    EXPECT_EQ(extentOf(scene), 112); // from the sphere's -12 to the mesh's 100
}

TEST(Extent, DoesNotDependOnWhereTheSceneLies) {
    Scene scene;
    scene.camera.position = {1e9, 0, 0};
    scene.bodies.push_back({Sphere{{1e9, 0, 8}, 1}, {}, {}, {}});
    EXPECT_EQ(extentOf(scene), 9);
}

} // namespace
} // namespace yarte::convert::povray
