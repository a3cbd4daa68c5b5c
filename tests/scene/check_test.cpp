#include "tests/scene/expect_problems.h"

namespace yarte {
namespace {

using test::expectGood;
using test::expectProblem;
using test::infinity;

TEST(CheckResolution, SidesAreInRange) {
    expectGood(check(Resolution{1, maxSide}));
    expectProblem(check(Resolution{0, 1}), "scene.resolution-out-of-range",
                  "image width must be from 1 to 1048576 pixels, got 0", 0);
    expectProblem(check(Resolution{1, maxSide + 1}), "scene.resolution-out-of-range",
                  "image height must be from 1 to 1048576 pixels, got 1048577", 1);
    EXPECT_EQ(check(Resolution{-1, -1}).size(), 2U);
}

TEST(CheckLight, BrightnessIsNotNegative) {
    expectGood(check(Light{{1, 2, 3}, {0, 0.5, 2}}));
    expectProblem(check(Light{{}, {0, -0.5, 0}}), "scene.colour-negative",
                  "brightness must not be negative, got -0.5", 4);
    expectProblem(check(Light{{0, infinity, 0}, {}}), "scene.not-finite", "a number must be finite, got inf",
                  1);
    expectProblem(check(Light{{}, {0, 0, std::nan("")}}), "scene.not-finite",
                  "a number must be finite, got nan", 5);
}

TEST(CheckMaterial, EveryValueHasItsRule) {
    Material good{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, 0, 0, 0, 0};
    expectGood(check(good));
    Material m = good;
    m.ambient.g = -1;
    expectProblem(check(m), "scene.colour-negative", "ambient colour must not be negative, got -1", 1);
    m = good, m.diffuse.b = -0.1;
    expectProblem(check(m), "scene.colour-negative", "diffuse colour must not be negative, got -0.1", 5);
    m = good, m.specular.r = -2;
    expectProblem(check(m), "scene.colour-negative", "specular colour must not be negative, got -2", 6);
    m = good, m.exponent = -1;
    expectProblem(check(m), "scene.exponent-negative", "the Phong exponent must not be negative, got -1", 9);
    m = good, m.reflection = -1;
    expectProblem(check(m), "scene.coefficient-negative",
                  "the reflection coefficient must not be negative, got -1", 10);
    m = good, m.transmission = -1;
    expectProblem(check(m), "scene.coefficient-negative",
                  "the transmission coefficient must not be negative, got -1", 11);
    m = good, m.tint.g = -1;
    expectProblem(check(m), "scene.colour-negative", "tint must not be negative, got -1", 14);
    expectProblem(checkTint(m.tint), "scene.colour-negative", "tint must not be negative, got -1", 1);
    m = good, m.tint.b = infinity;
    expectProblem(check(m), "scene.not-finite", "a number must be finite, got inf", 15);
    m = good, m.index = infinity;
    expectProblem(check(m), "scene.not-finite", "a number must be finite, got inf", 12);
}

TEST(CheckMaterial, IndexMattersOnlyWithTransmission) {
    Material m;
    for (const double index : {0.0, -1.0, 1.5}) {
        m.transmission = 0, m.index = index;
        expectGood(check(m));
    }
    m.transmission = 0.5;
    expectGood(check(m));
    m.index = 0;
    expectProblem(check(m), "scene.index-not-positive",
                  "the refraction index of a material that transmits must be positive, got 0", 12);
}

TEST(CheckBackColours, AreNotNegative) {
    expectGood(check(BackColours{}));
    BackColours back;
    back.specular.b = -1;
    expectProblem(check(back), "scene.colour-negative", "specular colour must not be negative, got -1", 8);
}

TEST(CheckCamera, PositionFocusAndUp) {
    const Camera good{{0, 0, 10}, {0, 0, 0}, {0, 1, 0}};
    expectGood(check(good));
    Camera camera = good;
    camera.position = {};
    expectProblem(check(camera), "scene.position-is-focus",
                  "the camera's position and its focus point must differ, both are 0 0 0", 1);
    camera = good, camera.up = {};
    expectProblem(check(camera), "scene.up-zero", "the up vector must not be of length 0", 2);
    for (const double z : {1.0, -3.0, 1e-320, 1e300}) {
        camera = good, camera.up = {0, 0, z};
        const Problems problems = check(camera);
        ASSERT_EQ(problems.size(), 1U) << z;
        EXPECT_EQ(problems[0].code, "scene.up-parallel");
        EXPECT_EQ(problems[0].argument, 2);
    }
    camera = good, camera.up = {1e-8, 0, 1};
    expectGood(check(camera));
    camera = good, camera.focus.x = infinity;
    expectProblem(check(camera), "scene.not-finite", "a number must be finite, got inf", 1);
}

TEST(CheckApertures, AreHalfAngles) {
    expectGood(checkApertures(1e-3, 89.9));
    const std::string rule =
        "aperture must be between 0 and 90 degrees (it is measured from the view axis), got ";
    expectProblem(checkApertures(0, 45), "scene.aperture-out-of-range", "the horizontal " + rule + "0", 0);
    expectProblem(checkApertures(45, 90), "scene.aperture-out-of-range", "the vertical " + rule + "90", 1);
}

TEST(CheckSettings, Others) {
    expectGood(checkBackground({0, 1, 2}));
    expectProblem(checkBackground({0, 0, -1}), "scene.colour-negative",
                  "background colour must not be negative, got -1", 2);
    expectGood(checkRecursion(0));
    expectGood(checkRecursion(255));
    expectProblem(checkRecursion(256), "scene.recursion-out-of-range",
                  "the recursion level must be from 0 to 255, got 256", 0);
    expectProblem(checkRecursion(-1), "scene.recursion-out-of-range",
                  "the recursion level must be from 0 to 255, got -1", 0);
    expectGood(checkGamma(2.2));
    expectProblem(checkGamma(0), "scene.gamma-not-positive", "gamma must be positive, got 0", 0);
    expectProblem(checkGamma(std::nan("")), "scene.not-finite", "a number must be finite, got nan", 0);
}

} // namespace
} // namespace yarte
