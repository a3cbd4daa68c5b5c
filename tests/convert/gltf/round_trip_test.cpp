// YARTE -> glTF -> YARTE is the identical canonical text.
#include "tests/convert/gltf/support.h"
#include "tests/convert/round_trip.h"
#include "tests/lang/random_scene.h"
#include "tests/support/program.h"

#include "yarte/lang/pmf.h"

#include <gtest/gtest.h>

namespace yarte::convert::test {
namespace {

namespace fs = std::filesystem;

void expectSame(const Scene& scene, bool binary, const std::string& what) {
    const std::string file = written(scene, binary);
    ASSERT_NE(file, "") << what;
    const ReadGltf back(file);
    ASSERT_TRUE(back.scene) << what << '\n' << back.problems();
    EXPECT_EQ(everything(*back.scene), everything(scene)) << what;
}

TEST(GltfRoundTrip, EverySceneOfOursIsTheSameText) {
    forEachSceneOfOurs([](const Scene& scene, const std::string& name) {
        expectSame(scene, true, name);
        expectSame(scene, false, name);
    });
}

class GltfRoundTripOf : public testing::TestWithParam<unsigned> {};

TEST_P(GltfRoundTripOf, ARandomSceneIsTheSameText) {
    for (unsigned i = 0; i < 25; ++i) {
        const unsigned seed = 25 * GetParam() + i;
        expectSame(yarte::test::SceneMaker(seed).make(), i % 2 == 0, "seed " + std::to_string(seed));
    }
}

INSTANTIATE_TEST_SUITE_P(Seeds, GltfRoundTripOf, testing::Range(0u, 8u));

TEST(GltfRoundTrip, AMeshFileKeepsItsPolygons) {
    const fs::path folder = yarte::test::emptyTestFolder();
    for (const char* name : {"paper/buck.pmf", "smooth_mesh/ball.pmf", "concave/concave.yarte"}) {
        const fs::path file = fs::path(YARTE_SOURCE_DIR) / "scenes" / name;
        const auto convertFile = [](const fs::path& from, const fs::path& to) {
            const Converted run(options(from, to));
            EXPECT_FALSE(run.files.empty()) << run.problems();
            for (const OutputFile& out : run.files) writeFile(out.file, out.bytes);
        };
        convertFile(file, folder / "direct.pmf");
        convertFile(folder / "direct.pmf", folder / "there.glb");
        convertFile(folder / "there.glb", folder / "back.pmf");
        EXPECT_EQ(readFile(folder / "back.pmf"), readFile(folder / "direct.pmf")) << name;
    }
}

TEST(GltfRoundTrip, BodiesThatShareAMeshAreTheSameText) {
    for (unsigned seed = 0; seed < 10; ++seed) {
        Scene scene = yarte::test::mixedScene(30, seed);
        scene.meshes[0].path = "tetrahedron.pmf";
        expectSame(scene, true, "seed " + std::to_string(seed));
    }
}

} // namespace
} // namespace yarte::convert::test
