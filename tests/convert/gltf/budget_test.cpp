// A few bytes that ask for much: they are refused, before the memory or the time is taken.
#include "tests/convert/gltf/support.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace yarte::convert::test {
namespace {

using testing::HasSubstr;

/// Nodes that all show one mesh; `position` is the accessor of its vertices, `more` are members of the
/// primitive, `nodeMembers` of each node.
std::string meshes(int nodes, const std::string& position, const std::string& more,
                   const std::string& nodeMembers, const std::string& rest) {
    std::string list, ids;
    for (int i = 0; i < nodes; ++i) {
        list += fmt::format("{}{{\"mesh\":0{}}}", i ? "," : "", nodeMembers);
        ids += fmt::format("{}{}", i ? "," : "", i);
    }
    return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[)" + ids + R"(]}],"nodes":[)" + list +
           R"(],"meshes":[{"primitives":[{"attributes":{"POSITION":0})" + more + R"(}]}],"accessors":[)" +
           position + "]" + rest + "}";
}

TEST(GltfBudget, ElementsThatAreNotThereAreNoMemory) {
    const ReadGltf read(meshes(
        1, R"({"bufferView":0,"componentType":5126,"type":"VEC3","count":300000000000000})", "", "",
        R"(,"bufferViews":[{"buffer":0,"byteLength":3600000000000000}],"buffers":[{"byteLength":3600000000000000,)"
        R"("uri":"data:application/octet-stream;base64,AAAA"}])"));
    EXPECT_FALSE(read.scene);
    EXPECT_THAT(read.problems(), HasSubstr("there are 3 bytes [gltf.bad-buffer]"));
}

TEST(GltfBudget, InstancesWithoutBytes) {
    const auto instances = [](int count) {
        return meshes(
            1,
            R"({"componentType":5126,"type":"VEC3","count":3},{"componentType":5126,"type":"VEC3",)" +
                fmt::format(R"("count":{}}})", count),
            "", R"(,"extensions":{"EXT_mesh_gpu_instancing":{"attributes":{"TRANSLATION":1}}})", "");
    };
    EXPECT_THAT(ReadGltf(instances(100)).problems(), testing::Not(HasSubstr("[gltf.too-large]")));
    const ReadGltf read(instances(65537));
    EXPECT_FALSE(read.scene);
    EXPECT_THAT(read.problems(), HasSubstr("65537 instances, and no buffer says where [gltf.too-large]"));
}

TEST(GltfBudget, TheSameElementsAgainAndAgain) {
    std::string targets, weights;
    for (int i = 0; i < 1000; ++i) {
        targets += fmt::format("{}{{\"POSITION\":0}}", i ? "," : "");
        weights += fmt::format("{}1", i ? "," : "");
    }
    const ReadGltf read(meshes(1, R"({"componentType":5126,"type":"VEC3","count":1048576})",
                               R"(,"targets":[)" + targets + "]", R"(,"weights":[)" + weights + "]", ""));
    EXPECT_FALSE(read.scene);
    EXPECT_THAT(read.problems(), HasSubstr("too many for a file of this size [gltf.too-large]"));
}

} // namespace
} // namespace yarte::convert::test
