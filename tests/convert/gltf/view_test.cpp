// glTF's lights and cameras, against values worked out by hand from convert/README.md.
#include "tests/convert/gltf/support.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace yarte::convert::test {
namespace {

using std::numbers::pi;

/// A triangle whose box has the centre (1, 0, 0) and the radius sqrt(2), and a node 1 with `node` within;
/// `more` are members of the root.
ReadGltf withNode(const std::string& node, const std::string& more) {
    return ReadGltf(
        R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0,1]}],)"
        R"("nodes":[{"mesh":0,"scale":[2,2,1],"translation":[0,-1,0]},{)" +
        node +
        R"(}],"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"accessors":[{"bufferView":0,)"
        R"("componentType":5126,"type":"VEC3","count":3}],"bufferViews":[{"buffer":0,"byteLength":36}],)"
        R"("buffers":[{"byteLength":36,"uri":"data:application/octet-stream;base64,)"
        // (0,0,0) (1,0,0) (0,1,0)
        R"(AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}],)" +
        more + "}");
}

ReadGltf withLight(const std::string& place, const std::string& light) {
    return withNode(
        place + R"("extensions":{"KHR_lights_punctual":{"light":0}})",
        R"("extensionsUsed":["KHR_lights_punctual"],"extensions":{"KHR_lights_punctual":{"lights":[)" +
            light + "]}}");
}

void expectNear(Vec3 got, Vec3 expected) {
    EXPECT_LT(length(got - expected), 1e-9) << got.x << ' ' << got.y << ' ' << got.z;
}

TEST(GltfLights, APointIsAsBrightAsAtTheScenesCentre) {
    // 5 away: 50 pi candela are 2 pi lux, a brightness of 2.
    const ReadGltf read = withLight(R"("translation":[1,3,4],)",
                                    R"({"type":"point","color":[1,0.5,0],"intensity":157.07963267948966})");
    ASSERT_TRUE(read.scene) << read.problems();
    const Light& light = read.scene->lights.at(0);
    expectNear(light.position, {1, 3, 4});
    EXPECT_NEAR(light.brightness.r, 2, 1e-12);
    EXPECT_NEAR(light.brightness.g, 1, 1e-12);
    EXPECT_EQ(light.brightness.b, 0);
}

TEST(GltfLights, TheSunStandsAHundredRadiiAway) {
    // Its rays go along the node's -z, here to +x, since the node is turned by -90 degrees about y.
    const ReadGltf read = withLight(R"("rotation":[0,-0.7071067811865476,0,0.7071067811865476],)",
                                    R"({"type":"directional","intensity":3.141592653589793})");
    ASSERT_TRUE(read.scene) << read.problems();
    const Light& light = read.scene->lights.at(0);
    expectNear(light.position, {1 - 100 * std::sqrt(2), 0, 0});
    EXPECT_NEAR(light.brightness.r, 1, 1e-12);
    EXPECT_TRUE(read.tells("/nodes/1", "directional light", Action::approximated));
}

TEST(GltfLights, WhatNoDisplayShowsIsExposed) {
    const ReadGltf read = withLight("", R"({"type":"directional","color":[1,0.5,0.25],"intensity":100000})");
    ASSERT_TRUE(read.scene) << read.problems();
    const Colour b = read.scene->lights.at(0).brightness;
    EXPECT_NEAR(b.r, 1, 1e-12);
    EXPECT_NEAR(b.g, 0.5, 1e-12);
    EXPECT_NEAR(b.b, 0.25, 1e-12);
    EXPECT_TRUE(read.tells("lights", "exposure", Action::approximated));
}

TEST(GltfCameras, PerspectiveHasHalfOfYfovAndItsAspect) {
    const ReadGltf read = withNode(
        R"("translation":[1,0,7],"camera":0)",
        R"("cameras":[{"type":"perspective","perspective":{"yfov":1,"aspectRatio":2,"znear":0.1}}])");
    ASSERT_TRUE(read.scene) << read.problems();
    const Camera& camera = read.scene->camera;
    expectNear(camera.position, {1, 0, 7});
    expectNear(camera.focus, {1, 0, 0});
    expectNear(camera.up, {0, 1, 0});
    EXPECT_NEAR(camera.verticalApertureDegrees, 90 / pi, 1e-12);
    EXPECT_NEAR(std::tan(camera.horizontalApertureDegrees * pi / 180), 2 * std::tan(0.5), 1e-12);
    EXPECT_EQ(read.scene->resolution.width, 640);
    EXPECT_EQ(read.scene->resolution.height, 320);
}

TEST(GltfCameras, OrthographicShowsTheSameAtTheScenesCentre) {
    const ReadGltf read = withNode(
        R"("translation":[1,0,4],"camera":0)",
        R"("cameras":[{"type":"orthographic","orthographic":{"xmag":3,"ymag":2,"znear":0.1,"zfar":9}}])");
    ASSERT_TRUE(read.scene) << read.problems();
    EXPECT_NEAR(std::tan(read.scene->camera.horizontalApertureDegrees * pi / 180), 3.0 / 4, 1e-12);
    EXPECT_NEAR(std::tan(read.scene->camera.verticalApertureDegrees * pi / 180), 2.0 / 4, 1e-12);
    EXPECT_TRUE(read.tells("/cameras/*", "type", Action::approximated)) << summary(read.ledger);
}

} // namespace
} // namespace yarte::convert::test
