#include "yarte/trace/media.h"

#include <gtest/gtest.h>

using namespace yarte;
using namespace yarte::trace;

namespace {

/// Bodies 0, 1, 2 with indices 1.5, 2, 2.
World threeGlasses() {
    World world;
    for (const double index : {1.5, 2.0, 2.0})
        world.bodies.push_back({{}, {}, {}, 1, 0, index, {1, 1, 1}, 1});
    return world;
}

constexpr BodyId a{0}, b{1}, c{2};

TEST(Media, EnteringFromTheVoidAndLeavingToIt) {
    const World world = threeGlasses();
    const Passage in = pass(world, {}, a);
    EXPECT_EQ(in.ratio, 1 / 1.5);
    EXPECT_EQ(in.after, MediaStack{a});
    EXPECT_FALSE(in.isContinued);
    const Passage out = pass(world, {a}, a);
    EXPECT_EQ(out.ratio, 1.5);
    EXPECT_TRUE(out.after.empty());
}

TEST(Media, NestedBodiesRefractBetweenTheirIndices) {
    const World world = threeGlasses();
    EXPECT_EQ(pass(world, {a}, b).ratio, 1.5 / 2);
    EXPECT_EQ(pass(world, {a}, b).after, (MediaStack{a, b}));
    EXPECT_EQ(pass(world, {a, b}, b).ratio, 2 / 1.5);
}

TEST(Media, OneDeeperInTheStackIsRemovedWithoutRefraction) {
    const World world = threeGlasses();
    const Passage out = pass(world, {a, b}, a);
    EXPECT_EQ(out.ratio, 1);
    EXPECT_TRUE(out.isContinued);
    EXPECT_EQ(out.after, MediaStack{b});
}

TEST(Media, EqualIndicesContinueOnlyBetweenTwoMedia) {
    World world = threeGlasses();
    EXPECT_TRUE(pass(world, {b}, c).isContinued);
    EXPECT_TRUE(pass(world, {b, c}, c).isContinued);
    world.bodies[0].index = 1; // as the void's: still a level of its own
    EXPECT_FALSE(pass(world, {}, a).isContinued);
    EXPECT_FALSE(pass(world, {a}, a).isContinued);
}

} // namespace
