// The kernels in float: what they are asked only where double would do better, and what must hold all the
// same.
#include "yarte/trace/lanes/lanes.h"
#include "yarte/trace/lanes/scalar.h"
#include "yarte/trace/world.h"

#include "tests/support/scenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

using namespace yarte;
using trace::Ray;

namespace {

constexpr Resolution size{80, 60};

std::vector<Colour> picture(const World& world) {
    std::vector<Colour> pixels(static_cast<std::size_t>(size.width * size.height));
    RayCounts rays;
    renderTile(world, {0, 0, size.width, size.height}, pixels.data(), static_cast<std::size_t>(size.width),
               rays);
    return pixels;
}

/// Pixels whose colours in float and in double differ by more than `tolerance`, or are no numbers.
int differing(const Scene& scene, double tolerance = 2. / 255) {
    const WorldPtr world = buildWorld(scene, size, Precision::inFloat);
    EXPECT_EQ(precisionOf(*world), Precision::inFloat);
    const std::vector<Colour> fast = picture(*world), exact = picture(*buildWorld(scene, size));
    int count = 0;
    for (std::size_t i = 0; i < fast.size(); ++i)
        count +=
            !(std::abs(fast[i].r - exact[i].r) <= tolerance &&
              std::abs(fast[i].g - exact[i].g) <= tolerance && std::abs(fast[i].b - exact[i].b) <= tolerance);
    return count;
}

/// Seen from (1, 2, 25), lit from two sides; of even seeds with planes among the bodies.
Scene mixedScene(int count, unsigned seed) {
    Scene scene = test::mixedScene(count, seed);
    if (seed % 2 == 0) test::addPlanes(scene, 3, seed);
    scene.camera.position = {1, 2, 25};
    scene.background = {0.1, 0.2, 0.3};
    scene.maxRecursion = 3;
    scene.lights.push_back({{20, 30, 25}, {0.6, 0.5, 0.4}, {}});
    scene.lights.push_back({{-3, 1, 2}, {0.5, 0.5, 0.7}, {}});
    return scene;
}

TEST(Precision, LooksAsInDouble) {
    for (const int count : {5, 60, 500}) // without and with a tree
        for (unsigned seed = 1; seed <= 4; ++seed)
            EXPECT_LE(differing(mixedScene(count, seed)), 8) << "bodies " << count << " seed " << seed;
}

Scene seenFromFar(Scene scene) {
    scene.camera.position = {1100, 1200, 1300};
    scene.camera.horizontalApertureDegrees = 0.4, scene.camera.verticalApertureDegrees = 0.3;
    return scene;
}

TEST(Precision, FromFarAway) {
    for (unsigned seed = 1; seed <= 4; ++seed)
        EXPECT_LE(differing(seenFromFar(mixedScene(500, seed))), 30) << "seed " << seed;
}

TEST(Precision, EveryInstructionSetGivesTheSameBytesWithATreeAndWithout) {
#ifdef __SANITIZE_ADDRESS__ // minutes a scene
    constexpr unsigned step = 4;
#else
    constexpr unsigned step = 1;
#endif
    for (unsigned seed = 1; seed <= 8; seed += step) {
        Scene scene = mixedScene(500, seed);
        if (seed > 4) scene = seenFromFar(std::move(scene));
        const WorldPtr world = buildWorld(scene, size, Precision::inFloat);
        World withoutTree = *world;
        withoutTree.tree = {};
        const std::vector<Colour> expected = picture(*world);
        for (const std::string& target : trace::laneTargets()) {
            trace::forceLaneTarget(target);
            for (const World* w : {world.get(), static_cast<const World*>(&withoutTree)})
                EXPECT_TRUE(picture(*w) == expected) << target << " seed " << seed;
        }
        trace::forceLaneTarget("");
    }
}

TEST(Precision, TheTreeLosesNothingAtTheEdgesOfItsBoxes) {
    // Bodies that fill their boxes, each with an edge of its outline where a pixel's ray from far away
    // passes.
    Scene scene = seenFromFar(test::emptyScene());
    const trace::CameraRays camera(scene.camera, size);
    for (int y = 0; y < size.height; y += 2)
        for (int x = 0; x < size.width; x += 2)
            test::add(scene,
                      Box{camera.through(x, y).at(length(scene.camera.position)) + Vec3{-0.1, 0, 0.1},
                          {0.2, 0.2, 0.2}},
                      {{1, 1, 1}, {}, {}, 1, 0, 0, 0});
    const WorldPtr world = buildWorld(scene, size, Precision::inFloat);
    World withoutTree = *world;
    withoutTree.tree = {};
    EXPECT_TRUE(picture(*world) == picture(withoutTree));
}

/// `scene` moved as a whole.
Scene moved(Scene scene, Vec3 by) {
    scene.camera.position += by, scene.camera.focus += by;
    for (Light& light : scene.lights) light.position += by;
    for (Body& body : scene.bodies)
        std::visit(
            [&]<class Shape>(Shape& shape) {
                if constexpr (std::is_same_v<Shape, Polygon>)
                    for (Vec3& vertex : shape.vertices) vertex += by;
                else if constexpr (std::is_same_v<Shape, Mesh>)
                    shape.translation += by;
                else if constexpr (std::is_same_v<Shape, Plane>)
                    shape.distance += dot(unitVector(shape.normal), by);
                else
                    shape.centre += by;
            },
            body.shape);
    return scene;
}

TEST(Precision, FarFromTheOriginIsAsGoodAsNear) {
    for (unsigned seed = 1; seed <= 4; ++seed)
        EXPECT_LE(differing(moved(mixedScene(60, seed), {1e7, -3e7, 2e7})), 8) << "seed " << seed;
}

/// A tilted wall of triangles with a corner where each pixel's ray meets it: all rays pass and start at
/// edges.
MeshData wallOfPixels(const Camera& view) {
    const trace::CameraRays camera(view, size);
    const Vec3 normal = normalised({0.3, -0.2, 1});
    MeshData wall;
    for (int y = -1; y <= size.height; ++y)
        for (int x = -1; x <= size.width; ++x) {
            const Ray ray = camera.through(x, y);
            wall.vertices.push_back(ray.at(-dot(ray.origin, normal) / dot(ray.direction, normal)));
        }
    for (int y = 0; y <= size.height; ++y)
        for (int x = 0; x <= size.width; ++x) {
            const auto row = static_cast<std::uint32_t>(size.width + 2),
                       a = static_cast<std::uint32_t>(y) * row + static_cast<std::uint32_t>(x), b = a + row;
            for (const std::uint32_t corner : {a, b, b + 1, a, b + 1, a + 1}) wall.corners.push_back(corner);
        }
    for (std::uint32_t c = 3; c <= wall.corners.size(); c += 3) wall.faceStarts.push_back(c);
    return wall;
}

TEST(Precision, NeighbouringTrianglesNeitherLeakNorShadeEachOther) {
    for (const bool isFar : {false, true}) {
        Scene scene = isFar ? seenFromFar(test::emptyScene()) : test::emptyScene();
        scene.background = {0, 0, 5};
        scene.lights.push_back({{-30, 3, 12}, {1, 1, 1}, {}});
        test::addMesh(scene, wallOfPixels(scene.camera), test::matt({0.5, 0.5, 0.5}));
        EXPECT_EQ(differing(scene, 1e-4), 0) << (isFar ? "far" : "near");
    }
}

TEST(Precision, StartsBetweenSurfacesThatAllButTouchAreNotInTheirShadow) {
    // A sweep of spheres: most points of each lie as near to its neighbours as rounding.
    Scene scene = test::emptyScene();
    for (int i = 0; i < 3000; ++i)
        test::add(scene, Sphere{{std::sin(i * 1e-3), std::cos(i * 1e-3), i * 1e-4}, 1 + i * 1e-4},
                  test::matt({0.8, 0.8, 0.8}));
    scene.lights.push_back({{50, 70, 60}, {1, 1, 1}, {}});
    EXPECT_LE(differing(scene), 2);
}

TEST(Precision, AWideSlopeUnderSmallThings) {
    Scene scene = test::emptyScene();
    scene.background = {0.2, 0.3, 0.4};
    const auto slope = [](double x, double z) -> Vec3 { return {x, 0.5 * x - 0.3 * z - 1, z}; };
    test::add(scene, Polygon{{slope(-1e5, -1e6), slope(-1e5, 1e6), slope(1e6, 1e6), slope(1e6, -1e6)}},
              test::mirror(0.5));
    for (int i = 0; i < 20; ++i)
        test::add(scene, Sphere{slope(i * 0.3 - 3, i % 5 - 2.) + Vec3{0, 0.1, 0}, 0.1},
                  test::matt({0.1 + i * 0.04, 0.5, 0.5}));
    scene.lights.push_back({{50, 70, 60}, {1, 1, 1}, {}});
    EXPECT_LE(differing(scene), 2);
}

TEST(Precision, WhatFloatCannotHoldIsTracedInDouble) {
    const auto precision = [](const Scene& scene, Resolution resolution) {
        return precisionOf(*buildWorld(scene, resolution, Precision::inFloat));
    };
    Scene scene = mixedScene(20, 1);
    EXPECT_EQ(precision(scene, size), Precision::inFloat);
    EXPECT_EQ(precisionOf(*buildWorld(scene, size)), Precision::inDouble);
    EXPECT_EQ(precision(scene, {1 << 18, 60}), Precision::inDouble); // narrow pixels
    EXPECT_EQ(precision(scene, {80, 1 << 18}), Precision::inDouble);

    Scene sunny = scene;
    sunny.lights.push_back({{1e20, 0, 0}, {1, 1, 1}, {}});
    EXPECT_EQ(precision(sunny, size), Precision::inDouble);

    Scene large = test::emptyScene(), small = large;
    test::add(large, Sphere{{0, 0, -1e10}, 1e9}, test::matt({1, 1, 1}));
    EXPECT_EQ(precision(large, size), Precision::inDouble);
    small.camera.position = {0, 0, 1e-6};
    test::add(small, Sphere{{0, 0, 0}, 1e-7}, test::matt({1, 1, 1}));
    EXPECT_EQ(precision(small, size), Precision::inDouble);
    EXPECT_EQ(precision(test::emptyScene(), size), Precision::inFloat);
}

TEST(Precision, AWorldInDoubleIsNotMoved) {
    const Scene scene = mixedScene(20, 1);
    EXPECT_EQ(buildWorld(scene, size)->camera.position, scene.camera.position);
    EXPECT_EQ(buildWorld(scene, {1 << 18, 60}, Precision::inFloat)->camera.position, scene.camera.position);
}

TEST(Precision, IdsInFloatsKeepTheirOrderBeyond24Bits) {
    using namespace trace::inFloat;
    std::uint32_t before = 0;
    for (const std::uint32_t id : {1u, 2u, (1u << 24) - 1, 1u << 24, (1u << 24) + 1, 2'000'000'000u}) {
        EXPECT_EQ(idIn(laneOf(id)), id);
        EXPECT_LT(laneOf(before), laneOf(id));
        before = id;
    }
    EXPECT_LT(laneOf(before), noElement);
    EXPECT_EQ(idIn(laneOf(0)), 0u);
}

} // namespace
