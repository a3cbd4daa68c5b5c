// Numbers near the limits of double: the same scene again, or an error; never a file that nobody can read.
#include "tests/convert/gltf/support.h"
#include "tests/support/scenes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace yarte::convert::test {
namespace {

using testing::HasSubstr;

Scene sphereOf(Vec3 centre, double radius) {
    Scene scene = yarte::test::emptyScene();
    yarte::test::add(scene, Sphere{centre, radius}, {{0.1, 0, 0}, {0.7, 0.3, 0.1}, {}, 1, 0, 0, 0});
    scene.lights.push_back({{1, 12.3, 4}, {0.9, 0.9, 0.8}});
    return scene;
}

void expectSame(const Scene& scene) {
    for (const bool binary : {true, false}) {
        const ReadGltf back(written(scene, binary));
        ASSERT_TRUE(back.scene) << back.problems();
        EXPECT_EQ(printScene(*back.scene), printScene(scene));
    }
}

TEST(GltfExtreme, VeryLargeScenesAreTheSameText) {
    for (const double size : {1e60, 1e150, 1e200, 1e300, 1.7e308}) {
        expectSame(sphereOf({0, size, 0}, 1));
        expectSame(sphereOf({}, size));
    }
}

TEST(GltfExtreme, VerySmallScenesAreTheSameText) {
    for (const double size : {1e-60, 1e-200, 1e-300}) expectSame(sphereOf({0, 0.1, 0}, size));
}

TEST(GltfExtreme, BlackLightsInVeryLargeScenesAreTheSameText) {
    Scene scene = sphereOf({0, 1.7e308, -1.7e308}, 1);
    scene.lights[0].brightness = {};
    expectSame(scene);
}

/// A triangle in a node of `node`; `more` are members of the root, `nodes` more nodes.
std::string triangle(const std::string& node, const std::string& nodes = "", const std::string& more = "") {
    return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0,1]}],"nodes":[{"mesh":0)" + node +
           "}," + (nodes.empty() ? "{}" : nodes) +
           R"(],"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"accessors":[{"bufferView":0,)"
           R"("componentType":5126,"type":"VEC3","count":3}],"bufferViews":[{"buffer":0,"byteLength":36}],)"
           R"("buffers":[{"byteLength":36,"uri":"data:application/octet-stream;base64,)"
           // (0,0,0) (1,0,0) (0,1,0)
           R"(AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}])" +
           more + "}";
}

TEST(GltfExtreme, ASceneTooLargeForACameraOfOursIsRefused) {
    EXPECT_TRUE(ReadGltf(triangle("")).scene);
    const ReadGltf read(triangle(R"(,"translation":[-1e308,0,0])", R"({"mesh":0})"));
    EXPECT_FALSE(read.scene);
    EXPECT_THAT(read.problems(), HasSubstr("[gltf.too-large]"));
}

TEST(GltfExtreme, TheDarkestLightsAreExposed) {
    const ReadGltf read(
        triangle("", R"({"translation":[0,0,1],"extensions":{"KHR_lights_punctual":{"light":0}}})",
                 R"(,"extensionsUsed":["KHR_lights_punctual"],"extensions":{"KHR_lights_punctual":)"
                 R"({"lights":[{"type":"point","intensity":1e-320}]}})"));
    ASSERT_TRUE(read.scene) << read.problems();
    ASSERT_EQ(read.scene->lights.size(), 1u);
    EXPECT_EQ(read.scene->lights[0].brightness.r, 1);
}

TEST(GltfExtreme, NumbersThatDoubleDoesNotHoldAreToldInPlainWords) {
    const ReadGltf read(triangle(R"(,"translation":[1e309,0,0])"));
    EXPECT_FALSE(read.scene);
    EXPECT_THAT(read.problems(), HasSubstr("number overflow parsing '1e309' [gltf.bad-json]"));
    EXPECT_THAT(read.problems(), Not(HasSubstr("exception")));
}

} // namespace
} // namespace yarte::convert::test
