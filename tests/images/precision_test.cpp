// --precision fast: every scene looks the same as in double, and is the same bytes however it is rendered.
#include "tests/support/scene_files.h"

#include "yarte/trace/lanes/lanes.h"
#include "yarte/trace/world.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

using namespace yarte;

namespace {

constexpr int width = 160, height = 120;

using Picture = std::vector<Colour>;

Picture render(const World& world, int tileWidth = width, int tileHeight = height) {
    Picture picture(width * height);
    RayCounts rays;
    for (int y = 0; y < height; y += tileHeight)
        for (int x = 0; x < width; x += tileWidth)
            renderTile(world, {x, y, std::min(x + tileWidth, width), std::min(y + tileHeight, height)},
                       &picture[static_cast<std::size_t>(y * width + x)], width, rays);
    return picture;
}

bool sameBytes(const Picture& a, const Picture& b) {
    return std::memcmp(a.data(), b.data(), a.size() * sizeof(Colour)) == 0;
}

class Fast : public testing::TestWithParam<std::string> {
protected:
    ~Fast() override { trace::forceLaneTarget(""); }

    const Scene scene_ = test::sceneNamed(GetParam());
    const WorldPtr world_ = buildWorld(scene_, {width, height}, Precision::inFloat);
};

/// What float explains: where a silhouette or a shadow's edge passes a pixel's centre by less than rounding,
/// the pixel takes the other side's colour. All others are the same to a small part of a display's step.
TEST_P(Fast, LooksAsInDouble) {
    ASSERT_EQ(precisionOf(*world_), Precision::inFloat);
    const Picture exact = render(*buildWorld(scene_, {width, height})), fast = render(*world_);
    int flipped = 0;
    double squares = 0;
    for (std::size_t i = 0; i < exact.size(); ++i) {
        const Colour a = fast[i], b = exact[i];
        ASSERT_TRUE(std::isfinite(a.r) && std::isfinite(a.g) && std::isfinite(a.b)) << "pixel " << i;
        const double error = std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
        if (error > 2. / 255)
            ++flipped;
        else
            squares += error * error;
    }
    EXPECT_LE(flipped, width * height / 4000);
    EXPECT_LE(std::sqrt(squares / (width * height)), 1e-4);
}

TEST_P(Fast, SameBytesOnEveryInstructionSetInAnyTilesAndWithoutATree) {
    const Picture expected = render(*world_);
    World withoutTree = *world_;
    withoutTree.tree = {};
    for (const std::string& target : trace::laneTargets()) {
        trace::forceLaneTarget(target);
        EXPECT_TRUE(sameBytes(render(*world_), expected)) << target;
        EXPECT_TRUE(sameBytes(render(*world_, 7, 13), expected)) << target << ", tiles of 7x13";
        EXPECT_TRUE(sameBytes(render(withoutTree), expected)) << target << ", no tree";
    }
}

INSTANTIATE_TEST_SUITE_P(Scenes, Fast, testing::ValuesIn(test::sceneNames()),
                         [](const auto& scene) { return scene.param; });

} // namespace
