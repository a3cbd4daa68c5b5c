// Reading glTF written by hand: transforms, modes, accessors, refusal.
#include "tests/convert/gltf/support.h"

#include "yarte/base/base64.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>

namespace yarte::convert::test {
namespace {

using testing::HasSubstr;

template <class T>
std::string raw(std::initializer_list<T> values) {
    std::string bytes(values.size() * sizeof(T), '\0');
    std::memcpy(bytes.data(), std::data(values), bytes.size());
    return bytes;
}

/// Five vertices of a zigzag strip in the plane z = 0.
const std::string zigzag = raw<float>({0, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 0, 2, 0, 0});

/// One mesh of the zigzag; `primitive` and `node` are more members of theirs, `more` of the root.
std::string zigzagFile(const std::string& primitive, const std::string& node = "", const std::string& more = "",
                       int count = 5) {
    return R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[0]}],"scene":0,"nodes":[{"mesh":0)" + node +
           R"(}],"meshes":[{"primitives":[{"attributes":{"POSITION":0})" + primitive +
           R"(}]}],"accessors":[{"bufferView":0,"componentType":5126,"type":"VEC3","min":[0,0,0],"max":[2,1,0],"count":)" +
           std::to_string(count) + R"(}],"bufferViews":[{"buffer":0,"byteLength":60}],"buffers":[{"byteLength":60,)" +
           R"("uri":"data:application/octet-stream;base64,)" + base64(zigzag) + "\"}]" + more + "}";
}

/// Its one mesh in world coordinates, corner by corner.
std::vector<Vec3> corners(const ReadGltf& read) {
    EXPECT_TRUE(read.scene) << read.problems();
    if (!read.scene || read.scene->bodies.size() != 1) return {};
    const Mesh& mesh = std::get<Mesh>(read.scene->bodies[0].shape);
    const MeshData& data = read.scene->meshes[mesh.mesh.index];
    const Vec3 z = mesh.axes.z && dot(*mesh.axes.z, *mesh.axes.z) > 0 ? *mesh.axes.z : cross(mesh.axes.x, mesh.axes.y);
    std::vector<Vec3> result;
    for (const std::uint32_t i : data.corners) {
        const Vec3 v = data.vertices[i] * mesh.scale;
        result.push_back(mesh.axes.x * v.x + mesh.axes.y * v.y + z * v.z + mesh.translation);
    }
    return result;
}

void expectNear(const std::vector<Vec3>& got, const std::vector<Vec3>& expected) {
    ASSERT_EQ(got.size(), expected.size());
    for (std::size_t i = 0; i < got.size(); ++i)
        EXPECT_LT(length(got[i] - expected[i]), 1e-12) << "corner " << i << ": " << got[i].x << ' ' << got[i].y << ' ' << got[i].z;
}

TEST(GltfRead, TriangleStripsTurnEverySecondTriangle) {
    expectNear(corners(ReadGltf(zigzagFile(R"(,"mode":5)"))),
               {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {1, 0, 0}, {1, 0, 0}, {1, 1, 0}, {2, 0, 0}});
}

TEST(GltfRead, TriangleFansKeepTheFirstVertex) {
    // Triangle i is (i + 1, i + 2, 0): section 3.7.2.1 of the specification.
    expectNear(corners(ReadGltf(zigzagFile(R"(,"mode":6)", "", "", 4))),
               {{0, 1, 0}, {1, 0, 0}, {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, 0}});
}

TEST(GltfRead, TrianglesTakeThreeVerticesEach) {
    expectNear(corners(ReadGltf(zigzagFile("", "", "", 3))), {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}});
}

TEST(GltfRead, PointsAndLinesAreDroppedAndTold) {
    for (const char* mode : {"0", "1", "2", "3"}) {
        const ReadGltf read(zigzagFile(std::string(",\"mode\":") + mode));
        ASSERT_TRUE(read.scene) << read.problems();
        EXPECT_TRUE(read.scene->bodies.empty());
        bool told = false;
        for (const LedgerRow& row : read.ledger.rows())
            told |= row.where == "/meshes/0/primitives/0" && row.action == Action::dropped;
        EXPECT_TRUE(told) << mode << '\n' << summary(read.ledger);
    }
}

TEST(GltfRead, MatricesAreByColumnsAndMayShear) {
    // x' = x + 2y + 5, y' = y, z' = z.
    expectNear(corners(ReadGltf(zigzagFile("", R"(,"matrix":[1,0,0,0, 2,1,0,0, 0,0,1,0, 5,0,0,1])", "", 3))),
               {{5, 0, 0}, {7, 1, 0}, {6, 0, 0}});
}

TEST(GltfRead, PartsAreScaleThenRotationThenTranslation) {
    // Twice as large, a quarter turn about z, then moved.
    expectNear(corners(ReadGltf(zigzagFile(
                   "", R"(,"scale":[2,2,2],"rotation":[0,0,0.7071067811865476,0.7071067811865476],"translation":[0,0,3])",
                   "", 3))),
               {{0, 0, 3}, {-2, 0, 3}, {0, 2, 3}});
}

TEST(GltfRead, MirroredNodesTurnTheirFaces) {
    const std::vector<Vec3> got = corners(ReadGltf(zigzagFile("", R"(,"scale":[-1,1,1])", "", 3)));
    ASSERT_EQ(got.size(), 3u);
    // The triangle (0,0,0) (0,1,0) (1,0,0) faces -z; mirrored it must still show the side that it shows outside: -z.
    EXPECT_LT(cross(got[1] - got[0], got[2] - got[0]).z, 0);
}

TEST(GltfRead, SparseAccessorsReplaceValues) {
    const std::string indices = raw<std::uint8_t>({1, 0, 0, 0}), values = raw<float>({0, 9, 0});
    const std::string text =
        R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[0]}],"scene":0,"nodes":[{"mesh":0}],)"
        R"("meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"accessors":[{"bufferView":0,"componentType":5126,)"
        R"("type":"VEC3","count":3,"min":[0,0,0],"max":[1,9,0],"sparse":{"count":1,"indices":{"bufferView":1,)"
        R"("componentType":5121},"values":{"bufferView":2}}}],"bufferViews":[{"buffer":0,"byteLength":36},)"
        R"({"buffer":0,"byteOffset":60,"byteLength":1},{"buffer":0,"byteOffset":64,"byteLength":12}],)"
        R"("buffers":[{"byteLength":76,"uri":"data:application/octet-stream;base64,)" +
        base64(zigzag + indices + values) + "\"}]}";
    expectNear(corners(ReadGltf(text)), {{0, 0, 0}, {0, 9, 0}, {1, 0, 0}});
}

TEST(GltfRead, NormalisedIntegersAreFractionsOfTheLargest) {
    const std::string data = raw<std::uint16_t>({0, 0, 0, 0, 0, 65535, 0, 0, 13107, 0, 0, 0});
    const std::string text =
        R"({"asset":{"version":"2.0"},"extensionsUsed":["KHR_mesh_quantization"],)"
        R"("extensionsRequired":["KHR_mesh_quantization"],"scenes":[{"nodes":[0]}],"scene":0,"nodes":[{"mesh":0}],)"
        R"("meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"accessors":[{"bufferView":0,"componentType":5123,)"
        R"("normalized":true,"type":"VEC3","count":3,"min":[0,0,0],"max":[13107,65535,0]}],"bufferViews":[{"buffer":0,)"
        R"("byteLength":24,"byteStride":8}],"buffers":[{"byteLength":24,"uri":"data:application/octet-stream;base64,)" +
        base64(data) + "\"}]}";
    expectNear(corners(ReadGltf(text)), {{0, 0, 0}, {0, 1, 0}, {0.2, 0, 0}});
}

TEST(GltfRead, UnknownRequiredExtensionsAreRefusedByName) {
    const ReadGltf read(zigzagFile("", "", R"(,"extensionsUsed":["ACME_x"],"extensionsRequired":["ACME_x"])", 3));
    EXPECT_FALSE(read.scene);
    EXPECT_THAT(read.problems(), HasSubstr("t.gltf#/extensionsRequired/0: error: "));
    EXPECT_THAT(read.problems(), HasSubstr("ACME_x"));
}

TEST(GltfRead, WhatReachesBeyondItsBufferIsRefusedWithItsPlace) {
    const ReadGltf read(zigzagFile("", "", "", 6));
    EXPECT_FALSE(read.scene);
    EXPECT_THAT(read.problems(), HasSubstr("/accessors/0"));
}

TEST(GltfRead, TextThatIsNoJsonIsRefused) {
    for (const char* text : {"", "{", "nonsense", "[]", "{}", "glTF", "{\"asset\":{\"version\":\"1.0\"}}"}) {
        const ReadGltf read{text};
        EXPECT_FALSE(read.scene) << text;
        EXPECT_THAT(read.problems(), HasSubstr("error: ")) << text;
    }
}

TEST(GltfRead, ANumberBeyondDoublesIsToldInPlainWords) {
    const ReadGltf read{R"({"asset":{"version":"2.0"},"extras":1e999})"};
    EXPECT_FALSE(read.scene);
    EXPECT_THAT(read.problems(), HasSubstr("the JSON is broken at byte 41: number"));
    EXPECT_THAT(read.problems(), Not(HasSubstr("json.exception")));
}

TEST(GltfRead, AFileWithoutCameraAndLightGetsThemAndSaysSo) {
    const ReadGltf read(zigzagFile("", "", "", 3));
    ASSERT_TRUE(read.scene);
    EXPECT_EQ(read.scene->lights.size(), 1u);
    EXPECT_TRUE(read.tells("camera", "everything", Action::added));
    EXPECT_TRUE(read.tells("light 1", "everything", Action::added));
}

} // namespace
} // namespace yarte::convert::test
