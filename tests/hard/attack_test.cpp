// Random rays next to every decision. YARTE_HARD_RAYS: how many per shape; ci/hard has a million.
#include "tests/hard/attack.h"

#include "yarte/trace/lanes/lanes.h"
#include "yarte/trace/world.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <cstring>

using namespace yarte;
using namespace yarte::hard;

namespace {

int raysPerShape() {
    const char* text = std::getenv("YARTE_HARD_RAYS");
    return text ? std::atoi(text) : YARTE_SHORT_ATTACK;
}

class Attack : public testing::TestWithParam<std::string_view> {};

TEST_P(Attack, NoWrongDecision) {
    Score score;
    const int count = raysPerShape();
    for (int i = 0; i < count; ++i) {
        test::Random random(static_cast<unsigned>(i)); // each can be repeated alone
        score.add(attack(GetParam(), random));
    }
    std::printf("%d rays, %d decidable, %d hits; %d wrong, %d inexact; worst t %.2f, normal %.2f\n",
                score.cases, score.decidable, score.hits, score.wrongDecisions, score.inexact, score.worstT,
                score.worstNormal);
    EXPECT_EQ(score.wrongDecisions, 0) << score.examples;
    EXPECT_EQ(score.inexact, 0) << score.examples;
    EXPECT_GT(score.hits, count / 20);
    EXPECT_GT(score.decidable, count / 4);
    EXPECT_LT(score.decidable, count);
}

/// What one ray, a mirrored and a transmitted one after it, and a light make of the pixel.
Colour pixelOf(const World& world, decltype(renderTile)& renderer) {
    Colour pixel;
    RayCounts counts;
    renderer(world, {0, 0, 1, 1}, &pixel, 1, counts);
    return pixel;
}

TEST_P(Attack, LanesGiveTheBitsOfThePlainCode) {
    for (int i = 0; i < 1000; ++i) {
        test::Random random(static_cast<unsigned>(i));
        Case c = attack(GetParam(), random);
        Material& material = c.scene.materials[0];
        material.reflection = 0.5, material.transmission = 0.5, material.index = 1.25;
        c.scene.background = {0.1, 0.2, 0.3};
        c.scene.lights.push_back({c.ray.origin + random.inCube(1), {1, 1, 1}, {}});
        World world = *buildWorld(c.scene, {1, 1});
        world.camera.position = c.ray.origin, world.camera.forward = c.ray.direction;
        world.camera.right = world.camera.up = {};
        const Colour plain = pixelOf(world, renderTileReference);
        for (const std::string& target : trace::laneTargets()) {
            trace::forceLaneTarget(target);
            const Colour lanes = pixelOf(world, renderTile);
            EXPECT_EQ(std::memcmp(&lanes, &plain, sizeof plain), 0) << target << ' ' << i << '\n'
                                                                    << toText(c);
        }
        trace::forceLaneTarget("");
    }
}

INSTANTIATE_TEST_SUITE_P(Shapes, Attack, testing::ValuesIn(attackedShapes()),
                         [](const auto& shape) { return std::string(shape.param); });

} // namespace
