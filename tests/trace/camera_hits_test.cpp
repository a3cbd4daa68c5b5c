// What camera rays meet, by the kernels: in double the reference's bits, in float near to them.
#include "yarte/trace/aov.h"
#include "yarte/trace/camera_hits.h"
#include "yarte/trace/lanes/lanes.h"

#include "tests/support/scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace yarte;

namespace {

constexpr Resolution size{37, 21};

Scene scene() {
    Scene scene = test::mixedScene(60, 2);
    test::addPlanes(scene, 1, 2);
    scene.camera.position = {1, 2, 25};
    return scene;
}

TEST(CameraHits, InDoubleAreTheReferencesOnEveryInstructionSet) {
    const Scene s = scene();
    const WorldPtr world = buildWorld(s, size);
    const Tile tile{3, 2, size.width, size.height};
    for (const std::string& target : trace::laneTargets()) {
        trace::forceLaneTarget(target);
        const std::vector<CameraHit> hits = cameraHits(*world, tile);
        ASSERT_EQ(hits.size(), static_cast<std::size_t>(tile.width() * tile.height()));
        std::size_t at = 0, met = 0;
        for (int y = tile.y0; y < tile.y1; ++y)
            for (int x = tile.x0; x < tile.x1; ++x, ++at) {
                const AovPixel pixel = aovPixel(*world, s.lights, x, y);
                ASSERT_EQ(hits[at].body, pixel.body) << target << ' ' << x << ' ' << y;
                if (pixel.body < 0) continue;
                ++met;
                EXPECT_EQ(hits[at].distance, pixel.depth);
                EXPECT_EQ(hits[at].normal, pixel.normal);
            }
        EXPECT_GT(met, 100u);
    }
    trace::forceLaneTarget("");
}

TEST(CameraHits, InFloatAreNearThemAndNotTheSame) {
    const Scene s = scene();
    const Tile all{0, 0, size.width, size.height};
    const std::vector<CameraHit> exact = cameraHits(*buildWorld(s, size), all),
                                 fast = cameraHits(*buildWorld(s, size, Precision::inFloat), all);
    double farthest = 0;
    int others = 0;
    for (std::size_t i = 0; i < exact.size(); ++i) {
        others += fast[i].body != exact[i].body;
        if (fast[i].body < 0 || fast[i].body != exact[i].body) continue;
        farthest = std::max(farthest, std::abs(fast[i].distance / exact[i].distance - 1));
    }
    EXPECT_LE(others, 2);
    EXPECT_GT(farthest, 1e-9);
    EXPECT_LT(farthest, 1e-4);
}

} // namespace
