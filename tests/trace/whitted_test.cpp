// Colours known in closed form.
#include "yarte/trace/whitted.h"

#include "tests/support/scenes.h"

#include <gtest/gtest.h>

using namespace yarte;
using namespace yarte::trace;

namespace {

constexpr Colour blue{0, 0, 1};

Colour look(const Scene& scene, Vec3 from, Vec3 direction, RayCounts* counts = nullptr) {
    const WorldPtr world = buildWorld(scene, {1, 1});
    RayCounts own;
    return Whitted(*world).colour({from, normalised(direction), {}}, counts ? *counts : own);
}

void expectNear(Colour a, Colour b, double tolerance = 1e-14) {
    EXPECT_NEAR(a.r, b.r, tolerance);
    EXPECT_NEAR(a.g, b.g, tolerance);
    EXPECT_NEAR(a.b, b.b, tolerance);
}

/// A large square facing +z at height z.
Polygon wall(double z) { return {{{-100, -100, z}, {100, -100, z}, {100, 100, z}, {-100, 100, z}}}; }

TEST(Whitted, NothingMetIsBackground) {
    Scene scene = test::emptyScene();
    scene.background = {0.1, 2, 0.3};
    expectNear(look(scene, {0, 0, 10}, {0, 0, -1}), {0.1, 2, 0.3}, 0);
}

TEST(Whitted, AmbientDiffuseAndSpecularAddUp) {
    Scene scene = test::emptyScene();
    test::add(scene, wall(0), {{0.1, 0.2, 0.3}, {0.5, 0, 1}, {0.25, 0.5, 0}, 7, 0, 0, 0});
    scene.lights.push_back({{3, 0, 4}, {2, 1, 0.5}, {}});
    // From straight above the origin: N.L = 4/5, R is the axis, so R.L = 4/5 too.
    const double p = std::pow(0.8, 7);
    expectNear(look(scene, {0, 0, 10}, {0, 0, -1}),
               {0.1 + 2 * (0.5 * 0.8 + 0.25 * p), 0.2 + 1 * (0.5 * p), 0.3 + 0.5 * (1 * 0.8)});
}

TEST(Whitted, LightBehindTheSurfaceGivesNothing) {
    Scene scene = test::emptyScene();
    test::add(scene, wall(0), {{0.1, 0.1, 0.1}, {1, 1, 1}, {1, 1, 1}, 1, 0, 0, 0});
    scene.lights.push_back({{0, 0, -4}, {1, 1, 1}, {}});
    RayCounts counts;
    expectNear(look(scene, {0, 0, 10}, {0, 0, -1}, &counts), {0.1, 0.1, 0.1}, 0);
    EXPECT_EQ(counts.shadow, 0u);
}

TEST(Whitted, BackColoursShowFromBehindOnly) {
    Scene scene = test::emptyScene();
    test::add(scene, wall(0), {{1, 0, 0}, {}, {}, 1, 0, 0, 0}).back = BackColours{{0, 1, 0}, {}, {}};
    expectNear(look(scene, {0, 0, 10}, {0, 0, -1}), {1, 0, 0}, 0);
    expectNear(look(scene, {0, 0, -10}, {0, 0, 1}), {0, 1, 0}, 0);
}

TEST(Whitted, ShadowOfGlassIsDimmedBySurfacesCrossed) {
    Scene scene = test::emptyScene();
    test::add(scene, wall(0), test::matt({1, 1, 1}));
    test::add(scene, yarte::Sphere{{0, 0, 5}, 1}, test::glass(0.5, 1.3));
    scene.lights.push_back({{0, 0, 20}, {1, 1, 1}, {}});
    scene.maxRecursion = 0;
    expectNear(look(scene, {0.5, 0, 3}, {-0.5, 0, -3}), {0.25, 0.25, 0.25});
}

TEST(Whitted, TintedGlassColoursWhatPassesOnly) {
    Scene scene = test::emptyScene();
    scene.background = {1, 1, 1};
    Material m = test::glass(0.5, 1.5);
    m.tint = {1, 0.5, 0};
    test::add(scene, yarte::Box{{0, 0, 0}, {100, 100, 2}}, m);
    scene.maxRecursion = 2;
    expectNear(look(scene, {0, 0, 10}, {0, 0, -1}), {0.25, 0.0625, 0}); // through both faces
    // Its shadow, on a wall below:
    scene.maxRecursion = 0;
    test::add(scene, wall(-3), test::matt({1, 1, 1}));
    scene.lights.push_back({{0, 0, 20}, {1, 1, 1}, {}});
    expectNear(look(scene, {0.5, 0, -2}, {-0.5, 0, -1}), {0.25, 0.0625, 0});
    // A black tint lets nothing pass: no ray is worth tracing.
    scene.materials[0].tint = {};
    scene.maxRecursion = 2;
    RayCounts counts;
    expectNear(look(scene, {0, 0, 10}, {0, 0, -1}, &counts), {}, 0);
    EXPECT_EQ(counts.transmitted, 0u);
}

TEST(Whitted, ParallelMirrorsGiveAGeometricSeries) {
    Scene scene = test::emptyScene();
    Material m = test::mirror(0.5);
    m.ambient = {1, 1, 1};
    test::add(scene, wall(0), m);
    test::add(scene, wall(4), m);
    for (const int n : {0, 1, 2, 5, 50}) {
        scene.maxRecursion = n;
        const double expected = 2 * (1 - std::pow(0.5, n + 1)); // sum of 2^-k, k = 0 ... n; black beyond
        RayCounts counts;
        expectNear(look(scene, {0, 0, 2}, {0.01, 0, -1}, &counts), {expected, expected, expected});
        EXPECT_EQ(counts.reflected, static_cast<std::uint64_t>(n));
    }
}

TEST(Whitted, SlabOfGlassShiftsTheRayAndKeepsItsDirection) {
    // Through a slab of thickness 2 and index 1.5 at 45 degrees the ray is shifted sideways; find the edge it
    // meets behind.
    Scene scene = test::emptyScene();
    test::add(scene, yarte::Box{{0, 0, 0}, {100, 100, 2}}, test::glass(1, 1.5));
    const double sinInside = std::sqrt(0.5) / 1.5,
                 tanInside = sinInside / std::sqrt(1 - sinInside * sinInside);
    const double exitX = -9 + 9 + 2 * tanInside; // in at (0, 0, 1) from (-9, 0, 10); out at z = -1
    // Half a plane of red from where the ray must arrive at z = -3.
    const double arrival = exitX + 2;
    for (const double side : {-1e-9, 1e-9}) {
        Scene with = scene;
        const double edge = arrival + side;
        test::add(with, Polygon{{{edge, -50, -3}, {edge + 90, -50, -3}, {edge + 90, 50, -3}, {edge, 50, -3}}},
                  {{1, 0, 0}, {}, {}, 1, 0, 0, 0});
        expectNear(look(with, {-9, 0, 10}, {1, 0, -1}), side < 0 ? Colour{1, 0, 0} : Colour{});
    }
}

TEST(Whitted, TotalReflectionTakesTheTransmittedWeight) {
    // From inside glass, beyond the critical angle, onto a surface with cr 0.25 and ct 0.5: both go to the
    // mirror ray.
    Scene scene = test::emptyScene();
    scene.camera.position = {0, 0, 0};
    scene.camera.focus = {0, 0, -1};
    Material m = test::glass(0.5, 1.5);
    m.reflection = 0.25;
    m.ambient = {};
    test::add(scene, yarte::Box{{0, 0, 0}, {100, 100, 2}}, m);
    test::add(scene, yarte::Sphere{{3, 0, 0}, 0.3}, {{1, 1, 1}, {}, {}, 1, 0, 0, 0});
    scene.maxRecursion = 1;
    // 56 degrees from the normal, above the critical 41.8: down to the face at z = -1 at x = 1.5 and up to x
    // = 3, z = 0.
    expectNear(look(scene, {0, 0, 0}, {1.5, 0, -1}), {0.75, 0.75, 0.75});
}

TEST(Whitted, TotalReflectionIsNotTinted) {
    Scene scene = test::emptyScene();
    scene.camera.position = {0, 0, 0};
    scene.camera.focus = {0, 0, -1};
    Material m = test::glass(0.5, 1.5);
    m.tint = {1, 0.5, 0};
    test::add(scene, yarte::Box{{0, 0, 0}, {100, 100, 2}}, m);
    test::add(scene, yarte::Sphere{{3, 0, 0}, 0.3}, {{1, 1, 1}, {}, {}, 1, 0, 0, 0});
    scene.maxRecursion = 1;
    expectNear(look(scene, {0, 0, 0}, {1.5, 0, -1}), {0.5, 0.5, 0.5}); // as in the test before
}

TEST(Whitted, IndexOneStillCountsLevels) {
    Scene scene = test::emptyScene();
    scene.background = blue;
    test::add(scene, yarte::Sphere{{0, 0, 0}, 1}, test::glass(1, 1));
    scene.maxRecursion = 1; // in, but not out
    expectNear(look(scene, {0, 0, 10}, {0, 0, -1}), {});
    scene.maxRecursion = 2;
    expectNear(look(scene, {0, 0, 10}, {0.02, 0.03, -1}), blue);
}

TEST(Whitted, BetweenEqualMediaARayContinuesWithoutALevelButNotFromTheLast) {
    Scene scene = test::emptyScene();
    scene.background = blue;
    test::add(scene, yarte::Sphere{{0, 0, 0}, 2}, test::glass(1, 1.5));
    test::add(scene, yarte::Sphere{{0, 0, 0}, 1}, test::glass(1, 1.5));
    scene.maxRecursion = 2; // into the outer, (inner free, out of it free), out of the outer
    expectNear(look(scene, {0, 0, 10}, {0, 0, -1}), blue);
    scene.maxRecursion = 1; // no level left at the inner sphere: not even a free one
    RayCounts counts;
    expectNear(look(scene, {0, 0, 10}, {0, 0, -1}, &counts), {});
    EXPECT_EQ(counts.transmitted, 1u);
}

TEST(Whitted, CameraInsideGlassStartsInIt) {
    Scene scene = test::emptyScene();
    scene.background = blue;
    scene.camera.position = {0.2, 0.1, 0};
    scene.camera.focus = {0.2, 0.1, -1};
    test::add(scene, yarte::Sphere{{0, 0, 0}, 2}, test::glass(1, 1.5));
    test::add(scene, yarte::Box{{0, 0, 0}, {1, 1, 1}}, test::glass(1, 1.2));
    test::add(scene, yarte::Sphere{{5, 0, 0}, 1}, test::glass(1, 1.2));
    test::add(scene, wall(-0.1), test::glass(1, 1.2)); // a polygon contains nothing
    const WorldPtr world = buildWorld(scene, {1, 1});
    EXPECT_EQ(world->cameraMedia,
              (MediaStack{{0}, {1}})); // the sphere's exit is farther: it is at the bottom
}

} // namespace
