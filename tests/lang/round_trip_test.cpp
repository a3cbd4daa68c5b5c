#include "tests/lang/random_scene.h"
#include "tests/lang/read_text.h"

#include "yarte/lang/scene_printer.h"

#include <gtest/gtest.h>

namespace yarte {
namespace {

TEST(RoundTrip, ScenesReadBackBitForBit) {
    for (unsigned seed = 0; seed < 500; ++seed) {
        const Scene scene = test::SceneMaker(seed).make();
        const std::string text = printScene(scene);
        const test::SceneText read(text);
        ASSERT_TRUE(read.scene) << "seed " << seed << "\n" << read.messages() << text;
        ASSERT_EQ(*read.scene, scene) << "seed " << seed;
        ASSERT_EQ(printScene(*read.scene), text) << "seed " << seed; // also tells -0 from 0
    }
}

TEST(RoundTrip, MeshesKeepTheirPlacement) {
    const std::string folder = std::string(YARTE_SOURCE_DIR) + "/tests/data/lang/good";
    const test::SceneText read(test::header + "mesh cube.pmf 0.3 0 1 0 0 0 1 0 0 0 1 -0 3\n"
                                              "mesh \"two words.pmf\" 1e-3 1 0 0 0 1 0 0 0 1 0 0 0\n",
                               folder);
    ASSERT_TRUE(read.scene) << read.messages();
    const std::string text = printScene(*read.scene);
    const test::SceneText again(text, folder);
    ASSERT_TRUE(again.scene) << again.messages();
    EXPECT_EQ(*again.scene, *read.scene);
    EXPECT_EQ(printScene(*again.scene), text);
}

} // namespace
} // namespace yarte
