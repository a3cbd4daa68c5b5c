#include "yarte/trace/search.h"

#include "tests/support/scenes.h"
#include "yarte/scene/referential.h"

#include <gtest/gtest.h>

using namespace yarte;
using namespace yarte::trace;

namespace {

TEST(Search, TreeFindsWhatBruteForceFindsToTheLastBit) {
    for (const unsigned seed : {1u, 2u, 3u, 4u, 5u}) {
        Scene scene = test::mixedScene(400, seed);
        const int planes = seed > 3 ? 3 : 0;
        test::addPlanes(scene, planes, seed);
        const WorldPtr world = buildWorld(scene, {64, 64});
        EXPECT_EQ(world->tree.entries.size() + static_cast<std::size_t>(planes), world->elements.size());
        ASSERT_FALSE(world->tree.empty());
        test::Random random(seed + 100);
        int hits = 0, partial = 0;
        for (int i = 0; i < 4000; ++i) {
            Ray ray{random.inCube(14), random.direction(), {}};
            if (i % 5 == 0) ray.direction = i % 2 ? Vec3{0, -1, 0} : Vec3{0, 0, 1}; // zero components
            const auto a = nearestHit(*world, ray), b = nearestHitBrute(*world, ray);
            ASSERT_EQ(a.has_value(), b.has_value()) << "seed " << seed << " ray " << i;
            const double distance = random.between(1, 30);
            const Colour lit = transmittance(*world, ray, distance);
            EXPECT_EQ(lit, transmittanceBrute(*world, ray, distance)) << "seed " << seed << " ray " << i;
            partial += !isBlack(lit) && lit != Colour{1, 1, 1};
            if (!a) continue;
            ++hits;
            EXPECT_EQ(a->t, b->t);
            EXPECT_EQ(a->element, b->element);
            // And on from there: the ray leaves the surface it met.
            const Ray next{
                ray.at(a->t), random.direction(), {a->element, a->entering ? Side::outside : Side::inside}};
            const auto c = nearestHit(*world, next), d = nearestHitBrute(*world, next);
            ASSERT_EQ(c.has_value(), d.has_value());
            if (c) {
                EXPECT_EQ(c->t, d->t);
                EXPECT_EQ(c->element, d->element);
            }
        }
        EXPECT_GT(hits, 1000);
        EXPECT_GT(partial, 50);
    }
}

TEST(Search, PlanesAreInNoTreeAndCountForNone) {
    Scene scene = test::emptyScene();
    test::addPlanes(scene, 20, 1);
    const WorldPtr planes = buildWorld(scene, {1, 1});
    EXPECT_EQ(planes->unbounded.size(), 20U);
    EXPECT_TRUE(planes->tree.empty());
    EXPECT_TRUE(nearestHit(*planes, {{0, 0, 0}, normalised({1, 2, 3}), {}}));
    for (int i = 0; i < 12; ++i) test::add(scene, yarte::Sphere{{double(i), 50, 0}, 0.4}, test::matt({}));
    EXPECT_EQ(buildWorld(scene, {1, 1})->tree.entries.size(), 12U);
}

TEST(Search, OfTwoAtEqualDistanceTheFirstInTheFileWins) {
    for (const int others : {0, 30}) { // without and with a tree
        Scene scene = test::emptyScene();
        test::add(scene, yarte::Polygon{{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}},
                  test::matt({1, 0, 0}));
        test::add(scene, yarte::Box{{0, 0, -1}, {2, 2, 2}}, test::matt({0, 1, 0}));
        for (int i = 0; i < others; ++i)
            test::add(scene, yarte::Sphere{{double(i), 50, 0}, 0.4}, test::matt({}));
        const auto first = nearestHit(*buildWorld(scene, {1, 1}), {{0.1, 0.2, 5}, {0, 0, -1}, {}});
        ASSERT_TRUE(first);
        EXPECT_EQ(first->element, ElementId{0});
        std::swap(scene.bodies[0], scene.bodies[1]);
        const WorldPtr swapped = buildWorld(scene, {1, 1});
        const auto second = nearestHit(*swapped, {{0.1, 0.2, 5}, {0, 0, -1}, {}});
        ASSERT_TRUE(second);
        EXPECT_EQ(second->element, ElementId{0});
        EXPECT_EQ(swapped->appearanceOf(second->element).diffuse[0], (Colour{0, 1, 0}));
    }
}

TEST(Search, ASphereDimsTheLightTwiceASheetOnce) {
    Scene scene = test::emptyScene();
    test::add(scene, yarte::Sphere{{0, 0, 0}, 1}, test::glass(0.5, 1.5));
    test::add(scene, yarte::Polygon{{{-1, -1, 3}, {1, -1, 3}, {0, 1, 3}}}, test::glass(0.25, 1));
    const WorldPtr world = buildWorld(scene, {1, 1});
    const Ray ray{{0, 0, -5}, {0, 0, 1}, {}};
    const auto grey = [](double v) { return Colour{v, v, v}; };
    EXPECT_EQ(transmittance(*world, ray, 5), grey(0.5));         // ends inside the sphere
    EXPECT_EQ(transmittance(*world, ray, 7), grey(0.25));        // behind it
    EXPECT_EQ(transmittance(*world, ray, 9), grey(0.25 * 0.25)); // and behind the sheet
    EXPECT_EQ(transmittance(*world, ray, 3), grey(1));
}

TEST(Search, TintsMultiplyByChannel) {
    Scene scene = test::emptyScene();
    Material reddish = test::glass(0.5, 1.5), greenish = test::glass(0.5, 1);
    reddish.tint = {1, 0.5, 0}, greenish.tint = {0, 1, 0.5};
    test::add(scene, yarte::Sphere{{0, 0, 0}, 1}, reddish);
    test::add(scene, yarte::Polygon{{{-1, -1, 3}, {1, -1, 3}, {0, 1, 3}}}, greenish);
    const WorldPtr world = buildWorld(scene, {1, 1});
    const Ray ray{{0, 0, -5}, {0, 0, 1}, {}};
    EXPECT_EQ(transmittance(*world, ray, 7), (Colour{0.25, 0.0625, 0}));
    EXPECT_EQ(transmittance(*world, ray, 9), (Colour{0, 0.03125, 0}));
}

TEST(Search, ARayNeverMeetsTheSurfaceItLeaves) {
    for (unsigned seed = 1; seed <= 20; ++seed) {
        Scene scene = test::mixedScene(10, seed); // one of each bounded kind
        test::addPlanes(scene, 1, seed);
        const WorldPtr world = buildWorld(scene, {1, 1});
        test::Random random(seed);
        for (std::uint32_t e = 0; e < world->elements.size(); ++e) {
            // Alone, so that whatever is met is the element itself.
            for (int i = 0; i < 200; ++i) {
                const Ray ray{random.inCube(12), random.direction(), {}};
                world->visit({e}, [&](const auto& shape) {
                    for (const Crossing& c : crossings(shape, ray)) {
                        const Vec3 point = ray.at(c.t), n = outwardNormal(shape, point, c.part);
                        Vec3 away = random.direction();
                        if (dot(away, n) < 0) away = -away;
                        World alone;
                        alone.elements = world->elements, alone.elementBody = world->elementBody;
                        alone.bodies = world->bodies, alone.spheres = world->spheres,
                        alone.boxes = world->boxes;
                        alone.cones = world->cones, alone.truncatedCones = world->truncatedCones;
                        alone.discs = world->discs, alone.faces = world->faces;
                        alone.frustums = world->frustums, alone.planes = world->planes;
                        const auto outside = nearestHitBrute(alone, {point, away, {{e}, Side::outside}});
                        EXPECT_TRUE(!outside || outside->element != ElementId{e})
                            << "seed " << seed << " element " << e;
                    }
                });
            }
        }
    }
}

/// A flat wall of jittered triangles, anywhere and turned anyhow.
MeshData wallOfTriangles(int n, test::Random& random) {
    const Frame axes = resolveReferential(random.referential());
    const Vec3 centre = random.inCube(random.between(0, 1000));
    const double side = std::exp(random.between(-3, 7));
    MeshData wall;
    for (int y = 0; y <= n; ++y)
        for (int x = 0; x <= n; ++x) {
            const double u = x + random.between(-0.4, 0.4), v = y + random.between(-0.4, 0.4);
            wall.vertices.push_back(centre + axes.toWorld({u * side, v * side, 0}));
        }
    const auto at = [n](int x, int y) { return static_cast<std::uint32_t>(y * (n + 1) + x); };
    for (int y = 0; y < n; ++y)
        for (int x = 0; x < n; ++x) {
            for (const auto corner : {at(x, y), at(x + 1, y), at(x + 1, y + 1)})
                wall.corners.push_back(corner);
            for (const auto corner : {at(x, y), at(x + 1, y + 1), at(x, y + 1)})
                wall.corners.push_back(corner);
        }
    for (std::uint32_t c = 3; c <= wall.corners.size(); c += 3) wall.faceStarts.push_back(c);
    return wall;
}

TEST(Search, AWallOfTrianglesCastsNoShadowOnItselfAlongEdges) {
    int count = 0;
    for (unsigned seed = 1; seed <= 200; ++seed) {
        test::Random random(seed);
        Scene scene = test::emptyScene();
        const MeshData wall = wallOfTriangles(4, random);
        test::addMesh(scene, wall, test::matt({1, 1, 1}));
        const Vec3 normal = triangleNormal(wall.vertices[0], wall.vertices[1], wall.vertices[6]);
        scene.camera.position = wall.vertices[0] + random.between(1, 5000) * normal;
        const WorldPtr world = buildWorld(scene, {1, 1});
        for (int i = 0; i < 200; ++i) {
            const auto face =
                wall.face(static_cast<std::size_t>(random.below(static_cast<int>(wall.faceCount()))));
            const Vec3 a = wall.vertices[face[0]], b = wall.vertices[face[1]];
            const Vec3 target = a + random.between(0, 1) * (b - a);
            const Ray ray{scene.camera.position, normalised(target - scene.camera.position), {}};
            const auto hit = nearestHit(*world, ray);
            if (!hit) continue; // a rim's edge
            const Side side = hit->entering ? Side::outside : Side::inside;
            const Vec3 toLight = normalised(random.direction() + 1.1 * normal);
            EXPECT_EQ(transmittance(*world, {ray.at(hit->t), toLight, {hit->element, side}}, 1e9),
                      (Colour{1, 1, 1}))
                << "seed " << seed;
            ++count;
        }
    }
    EXPECT_GT(count, 20000);
}

} // namespace
