// What is known of a pixel besides its colour, in closed form.
#include "yarte/trace/aov.h"

#include "tests/support/scenes.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace yarte;

namespace {

/// A camera at (0, 0, 10) that looks along -z; its middle pixel is (1, 1) of 3x3.
Scene sceneFromAbove() {
    Scene scene = test::emptyScene();
    scene.camera.position = {0, 0, 10};
    scene.camera.focus = {0, 0, 0};
    scene.camera.horizontalApertureDegrees = scene.camera.verticalApertureDegrees = 5;
    return scene;
}

AovPixel middle(const Scene& scene) { return aovPixel(*buildWorld(scene, {3, 3}), scene.lights, 1, 1); }

/// A large square facing +z at height z.
yarte::Polygon wall(double z) { return {{{-100, -100, z}, {100, -100, z}, {100, 100, z}, {-100, 100, z}}}; }

TEST(Aov, TellsWhatTheCameraRayMeets) {
    Scene scene = sceneFromAbove();
    test::add(scene, yarte::Sphere{{50, 0, 0}, 1}, test::matt({1, 1, 1}));
    test::add(scene, yarte::Sphere{{0, 0, 0}, 2}, test::matt({1, 1, 1}));
    const AovPixel pixel = middle(scene);
    EXPECT_EQ(pixel.body, 1);
    EXPECT_NEAR(pixel.depth, 8, 1e-12);
    EXPECT_NEAR(pixel.normal.z, 1, 1e-12);
    EXPECT_FALSE(pixel.isBack);
    EXPECT_EQ(pixel.reflectedBody, -1);
    EXPECT_EQ(pixel.transmittedBody, -1);
}

TEST(Aov, NothingMetIsBackgroundWithItsWholeWeight) {
    const AovPixel pixel = middle(sceneFromAbove());
    EXPECT_EQ(pixel.body, -1);
    EXPECT_EQ(pixel.depth, -1);
    EXPECT_EQ(pixel.backgroundWeight, (Colour{1, 1, 1}));
}

TEST(Aov, ALightIsArrivingAsFarAsShadowsLeaveIt) {
    Scene scene = sceneFromAbove();
    test::add(scene, wall(0), test::matt({1, 1, 1}));
    test::add(scene, yarte::Sphere{{3, 0, 4}, 1}, test::glass(0.5, 1.3)); // between the origin and light 0
    scene.lights.push_back({{6, 0, 8}, {1, 1, 1}, {}});
    scene.lights.push_back({{-6, 0, 8}, {1, 1, 1}, {}});
    const AovPixel pixel = middle(scene);
    ASSERT_EQ(pixel.body, 0);
    ASSERT_EQ(pixel.lights.size(), 2u);
    EXPECT_NEAR(pixel.lights[0].arriving.g, 0.25, 1e-15);
    EXPECT_EQ(pixel.lights[1].arriving, (Colour{1, 1, 1}));
    EXPECT_NEAR(pixel.lights[0].lambert, 0.8, 1e-15);
    EXPECT_NEAR(pixel.lights[1].mirror, 0.8, 1e-15);
    EXPECT_TRUE(pixel.casting[1]);
    EXPECT_FALSE(pixel.casting[0]);
    // Each light's share adds up to what it brings: D·(N·L)·B.
    EXPECT_NEAR(pixel.lightShare[0].g, 0.25 * 0.8, 1e-15);
    EXPECT_NEAR(pixel.lightShare[1].g, 0.8, 1e-15);
}

TEST(Aov, SecondaryRaysNameTheBodiesTheyMeet) {
    Scene scene = sceneFromAbove();
    test::add(scene, wall(0), {{}, {}, {}, 1, 0.25, 0, 0});
    test::add(scene, yarte::Polygon{{{-50, -50, 30}, {-50, 50, 30}, {50, 50, 30}, {50, -50, 30}}},
              test::matt({1, 1, 1})); // above the camera, seen in the mirror
    scene.maxRecursion = 1;
    const AovPixel pixel = middle(scene);
    EXPECT_EQ(pixel.body, 0);
    EXPECT_EQ(pixel.reflectedBody, 1);
    ASSERT_GE(pixel.visits.size(), 2u);
    EXPECT_EQ(pixel.visits[0].body, 0);
    EXPECT_EQ(pixel.visits[0].weight, (Colour{1, 1, 1}));
    EXPECT_EQ(pixel.visits[1].body, 1);
    EXPECT_EQ(pixel.visits[1].weight, (Colour{0.25, 0.25, 0.25}));
    EXPECT_TRUE(pixel.secondary[1]);
    EXPECT_FALSE(pixel.secondary[0]);
}

/// A visit says how much the colour changes when a property grows by 1.
TEST(Aov, AVisitIsTheSlopeOfTheColour) {
    Scene scene = sceneFromAbove();
    test::add(scene, wall(0), {{0.1, 0.1, 0.1}, {0.5, 0.5, 0.5}, {0.25, 0.25, 0.25}, 7, 0, 0, 0});
    scene.lights.push_back({{3, 0, 4}, {2, 1, 0.5}, {}});
    const AovPixel pixel = middle(scene);
    ASSERT_EQ(pixel.visits.size(), 1u);
    EXPECT_EQ(pixel.visits[0].weight, (Colour{1, 1, 1}));
    EXPECT_NEAR(pixel.visits[0].lit.r, 2 * 0.8, 1e-14);
    EXPECT_NEAR(pixel.visits[0].highlight.b, 0.5 * std::pow(0.8, 7), 1e-14);
}

TEST(Aov, ATintIsInTheWeights) {
    Scene scene = sceneFromAbove();
    Material glass = test::glass(0.5, 1.5);
    glass.tint = {1, 0.5, 0};
    test::add(scene, yarte::Disc{{0, 0, 5}, 3}, glass).referential = Referential{{1, 0, 0}, {0, 0, 1}, {}};
    test::add(scene, wall(0), {{0.25, 0.25, 0.25}, {}, {}, 1, 0, 0, 0});
    const AovPixel pixel = middle(scene);
    ASSERT_EQ(pixel.visits.size(), 2u);
    EXPECT_EQ(pixel.visits[1].body, 1);
    EXPECT_EQ(pixel.visits[1].weight, (Colour{0.5, 0.25, 0}));
    EXPECT_EQ(pixel.visits[0].transmitted, (Colour{0.25, 0.125, 0})) << "what grows with ct";
}

TEST(Aov, TheBackIsSeenAsTheBack) {
    Scene scene = sceneFromAbove();
    test::add(scene, yarte::Polygon{{{-50, -50, 0}, {-50, 50, 0}, {50, 50, 0}, {50, -50, 0}}},
              test::matt({1, 1, 1}))
        .back = BackColours{{0, 1, 0}, {}, {}};
    const AovPixel pixel = middle(scene);
    EXPECT_TRUE(pixel.isBack);
    EXPECT_NEAR(pixel.normal.z, 1, 1e-15) << "turned to the viewer";
}

} // namespace
