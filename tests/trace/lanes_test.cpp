// Every instruction set gives the bits of the plain code.
#include "yarte/trace/lanes/lanes.h"

#include "tests/support/scenes.h"
#include "yarte/trace/world.h"

#include <gtest/gtest.h>

#include <cstring>

using namespace yarte;

namespace {

struct Picture {
    std::vector<Colour> pixels;
    RayCounts counts;
};

Picture render(const World& world, Tile tile, decltype(renderTile)& renderer) {
    Picture picture;
    picture.pixels.resize(static_cast<std::size_t>(tile.width() * tile.height()));
    renderer(world, tile, picture.pixels.data(), static_cast<std::size_t>(tile.width()), picture.counts);
    return picture;
}

bool sameBits(const Picture& a, const Picture& b) {
    return a.pixels.size() == b.pixels.size() && a.counts == b.counts &&
           std::memcmp(a.pixels.data(), b.pixels.data(), a.pixels.size() * sizeof(Colour)) == 0;
}

class EveryTarget : public testing::TestWithParam<std::string> {
protected:
    void SetUp() override { trace::forceLaneTarget(GetParam()); }
    void TearDown() override { trace::forceLaneTarget(""); }
};

TEST_P(EveryTarget, GivesTheBitsOfThePlainCode) {
    for (const int count : {5, 11, 60, 500}) { // without and with a tree
        for (unsigned seed = 1; seed <= 4; ++seed) {
            Scene scene = test::mixedScene(count, seed);
            if (seed > 2) test::addPlanes(scene, 3, seed);
            scene.camera.position = {1, 2, 25};
            scene.background = {0.1, 0.2, 0.3};
            scene.maxRecursion = 5;
            scene.lights.push_back({{20, 30, 25}, {0.6, 0.5, 0.4}, {}});
            scene.lights.push_back({{-3, 1, 2}, {0.5, 0.5, 0.7}, {}}); // among the bodies
            const WorldPtr world = buildWorld(scene, {75, 61});
            const Tile tile{3, 2, 75, 61};
            EXPECT_TRUE(sameBits(render(*world, tile, renderTile), render(*world, tile, renderTileReference)))
                << "bodies " << count << " seed " << seed;
        }
    }
}

TEST_P(EveryTarget, LightBuffers) {
    for (unsigned seed = 1; seed <= 3; ++seed) {
        Scene scene = test::smallBodies(1500, seed);
        test::addPlanes(scene, seed == 3 ? 2 : 0, seed);
        scene.camera.position = {1, 2, 25};
        scene.maxRecursion = 3;
        scene.lights.push_back({{20, 30, 25}, {0.6, 0.5, 0.4}, {}});
        scene.lights.push_back({{0, 0, 0}, {0.5, 0.5, 0.7}, {}}); // among the bodies
        scene.lights.push_back({{-1e4, 1e4, 1e4}, {0.3, 0.2, 0.1}, {}});
        scene.lights.push_back({{0, 1e12, 0}, {0.1, 0.2, 0.1}, {}}); // too far for a buffer
        const WorldPtr world = buildWorld(scene, {400, 400});
        ASSERT_EQ(world->lightBuffers.size(), 4U);
        for (const std::size_t light : {0u, 1u, 2u})
            EXPECT_FALSE(world->lightBuffers[light].empty()) << light;
        EXPECT_TRUE(world->lightBuffers[3].empty());
        const Tile tile{170, 160, 240, 220};
        EXPECT_TRUE(sameBits(render(*world, tile, renderTile), render(*world, tile, renderTileReference)))
            << "seed " << seed;
    }
}

TEST_P(EveryTarget, SmoothMeshes) {
    Scene scene = test::emptyScene();
    test::Random random(3);
    MeshData ball; // a bumpy sphere of triangles with the normals of a smooth one
    const int n = 12;
    for (int y = 0; y <= n; ++y)
        for (int x = 0; x <= n; ++x) {
            const double u = 2 * M_PI * x / n, v = M_PI * (y + 0.01) / (n + 0.02);
            const Vec3 p{std::sin(v) * std::cos(u), std::cos(v), std::sin(v) * std::sin(u)};
            ball.vertices.push_back(p * 3);
            ball.normals.push_back(normalised(p + 0.2 * random.direction()));
        }
    for (std::uint32_t y = 0; y < n; ++y)
        for (std::uint32_t x = 0; x < n; ++x) {
            const std::uint32_t a = y * (n + 1) + x, b = a + 1, c = a + n + 1, d = c + 1;
            for (const std::uint32_t corner : {a, b, d, a, d, c}) ball.corners.push_back(corner);
            ball.faceStarts.push_back(static_cast<std::uint32_t>(ball.corners.size() - 3));
            ball.faceStarts.push_back(static_cast<std::uint32_t>(ball.corners.size()));
        }
    ball.cornerNormals = ball.corners;
    Material material = test::matt({0.4, 0.5, 0.6});
    material.specular = {1, 1, 1}, material.exponent = 30, material.reflection = 0.3;
    test::addMesh(scene, ball, material).back = BackColours{{0.5, 0, 0}, {1, 0, 0}, {}};
    scene.lights.push_back({{5, 6, 7}, {1, 1, 1}, {}});
    const WorldPtr world = buildWorld(scene, {80, 60});
    const Tile tile{0, 0, 80, 60};
    EXPECT_TRUE(sameBits(render(*world, tile, renderTile), render(*world, tile, renderTileReference)));
}

TEST_P(EveryTarget, LinesAlongAxesAndPlanes) {
    // Rays along cylinders, in the planes of lids and of planes, and through an apex: where coefficients
    // vanish.
    Scene scene = test::emptyScene();
    scene.camera.position = {0, 0, 8};
    scene.background = {0.1, 0.2, 0.3};
    const Referential towards{{1, 0, 0}, {0, 0, 1}, {}};
    const auto turned = [&](Shape shape) {
        test::add(scene, std::move(shape), test::matt({0.5, 0.6, 0.7})).referential = towards;
    };
    turned(Cylinder{{0, 0, 0}, 0.5, 1});
    turned(OpenCylinder{{0, 0, 2}, 0.7, 1});
    turned(Frustum{{0, 0, -2}, 2, 1, 1});
    turned(Cone{{2, 0, 0}, 1, 1});
    test::add(scene, Plane{{0, 1, 0}, 0}, test::matt({1, 0, 0}));
    test::add(scene, Plane{{0, 0, 1}, -3}, test::mirror(1));
    scene.lights.push_back({{0, 0, 5}, {1, 1, 1}, {}});
    const WorldPtr world = buildWorld(scene, {65, 65}); // odd: the middle ones look along the axes
    const Tile tile{0, 0, 65, 65};
    EXPECT_TRUE(sameBits(render(*world, tile, renderTile), render(*world, tile, renderTileReference)));
}

INSTANTIATE_TEST_SUITE_P(Lanes, EveryTarget, testing::ValuesIn(trace::laneTargets()),
                         [](const auto& target) { return target.param; });

TEST(Lanes, MeasuringChangesNothing) {
    Scene scene = test::mixedScene(100, 9);
    scene.camera.position = {1, 2, 25};
    scene.lights.push_back({{20, 30, 25}, {0.6, 0.5, 0.4}, {}});
    const WorldPtr world = buildWorld(scene, {384, 288});
    const Tile tile{0, 0, 384, 288};
    TraceTimes times;
    const Picture plain = render(*world, tile, renderTile), measured = [&] {
        Picture picture;
        picture.pixels.resize(plain.pixels.size());
        renderTileTimed(*world, tile, picture.pixels.data(), 384, picture.counts, times);
        return picture;
    }();
    EXPECT_TRUE(sameBits(measured, plain));
    // A busy machine may disturb all blocks of a sample; other blocks are measured the next time.
    for (int again = 0; again < 100 && (times.camera == 0 || times.shadow == 0 || times.secondary == 0);
         ++again) {
        std::vector<Colour> pixels(plain.pixels.size());
        RayCounts counts;
        renderTileTimed(*world, tile, pixels.data(), 384, counts, times);
    }
    EXPECT_GT(times.seconds, 0);
    EXPECT_GT(times.camera, 0U);
    EXPECT_GT(times.shadow, 0U);
    EXPECT_GT(times.secondary, 0U);
    EXPECT_GT(times.sampled, times.camera + times.shadow + times.secondary);
    EXPECT_DOUBLE_EQ(times.secondsOf(times.sampled), times.seconds);
}

} // namespace
