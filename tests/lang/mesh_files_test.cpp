#include "tests/lang/read_text.h"

#include <gtest/gtest.h>

namespace yarte {
namespace fs = std::filesystem;
namespace {

const std::string triangle = "3 1\n0 0 0\n1 0 0\n0 1 0\n0 1 2\n";

std::string mesh(const std::string& name) { return "mesh " + name + " 1 1 0 0 0 1 0 0 0 1 0 0 0\n"; }

struct MeshFilesTest : testing::Test {
    MeshFilesTest() {
        fs::remove_all(root);
        fs::create_directories(folder / "below");
        fs::create_directories(root / "other");
        writeFile(folder / "a.pmf", triangle);
        writeFile(folder / "below" / "b.PMF", triangle);
        writeFile(root / "other" / "c.pmf", triangle);
    }
    ~MeshFilesTest() override { fs::remove_all(root); }

    void expectError(const std::string& name, const std::string& code) const {
        const test::SceneText read(test::header + mesh(name), folder);
        ASSERT_EQ(read.diagnostics.all().size(), 1U) << read.messages();
        EXPECT_EQ(read.diagnostics.all()[0].code, code);
        EXPECT_EQ(read.diagnostics.all()[0].span.begin, test::header.size() + 5);
    }

    fs::path root = fs::path(YARTE_TEST_OUTPUT) / "mesh-files" /
                    testing::UnitTest::GetInstance()->current_test_info()->name();
    fs::path folder = root / "scene";
};

TEST_F(MeshFilesTest, FileNamedTwiceIsReadOnce) {
    fs::create_symlink("a.pmf", folder / "link.pmf");
    const test::SceneText read(test::header + mesh("a.pmf") + mesh("below/b.PMF") + mesh("./below/../a.pmf") +
                                   mesh("link.pmf") + mesh((fs::absolute(folder) / "a.pmf").string()),
                               folder);
    ASSERT_EQ(read.messages(), "");
    ASSERT_EQ(read.scene->meshes.size(), 2U);
    EXPECT_EQ(read.scene->meshes[0].path, "a.pmf");
    EXPECT_EQ(read.scene->meshes[1].path, "below/b.PMF");
    std::vector<std::uint32_t> ids;
    for (const Body& body : read.scene->bodies) ids.push_back(std::get<Mesh>(body.shape).mesh.index);
    EXPECT_EQ(ids, (std::vector<std::uint32_t>{0, 1, 0, 0, 0}));
}

TEST_F(MeshFilesTest, MeshesInMemoryNeedNoFile) {
    MeshData given;
    given.path = "in memory";
    given.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    given.corners = {0, 1, 2};
    given.faceStarts = {0, 3};
    const std::string twice = mesh("\"in memory\"") + mesh("a.pmf") + mesh("\"in memory\"");
    const SceneReading reading{{}, test::pmfOnly, std::span(&given, 1)};
    const test::SceneText read(test::header + twice, folder, reading);
    ASSERT_EQ(read.messages(), "");
    ASSERT_EQ(read.scene->meshes.size(), 2U);
    EXPECT_EQ(read.scene->meshes[0], given);
    EXPECT_EQ(std::get<Mesh>(read.scene->bodies[2].shape).mesh, MeshId{0});
}

TEST_F(MeshFilesTest, MustLieInTheFolderOrBelow) {
    fs::create_symlink(root / "other" / "c.pmf", folder / "out.pmf");
    expectError("../other/c.pmf", "scene.path-not-allowed");
    expectError(fs::absolute(root / "other" / "c.pmf").string(), "scene.path-not-allowed");
    expectError("out.pmf", "scene.path-not-allowed");
    expectError("../other/none.pmf", "scene.path-not-allowed"); // nothing is told about what is outside
}

TEST_F(MeshFilesTest, AllowedFoldersAreReadToo) {
    const SceneReading reading{{{root / "other"}}, test::pmfOnly};
    EXPECT_EQ(test::SceneText(test::header + mesh("../other/c.pmf"), folder, reading).messages(), "");
    EXPECT_NE(test::SceneText(test::header + mesh("../other2/c.pmf"), folder, reading).messages(), "");
}

TEST_F(MeshFilesTest, WhatIsNoReadableFileIsAnErrorAtItsName) {
    expectError("none.pmf", "scene.mesh-unreadable");
    expectError("below", "scene.mesh-unreadable");
    expectError("a.pmf/x.pmf", "scene.mesh-unreadable");
    writeFile(folder / "a.stl", "");
    expectError("a.stl", "scene.unknown-mesh-format");
    writeFile(folder / "noending", "");
    expectError("noending", "scene.unknown-mesh-format");
}

TEST_F(MeshFilesTest, FormatsAreTheTablesOwn) {
    static constexpr MeshFormat formats[] = {
        {".pmf", readPmf},
        {".dot",
         [](const fs::path&, const ReadableFolders& readable, Sources&,
            Diagnostics& diagnostics) -> std::optional<MeshData> {
             diagnostics.error("test.called", readable.folders.empty() ? "no folder" : "called");
             return std::nullopt;
         }}};
    writeFile(folder / "a.Dot", "");
    const test::SceneText read(test::header + mesh("a.Dot") + mesh("a.Dot"), folder, {{}, formats});
    EXPECT_EQ(read.messages(), "error: called [test.called]\n"); // once for both
    writeFile(folder / "a.x", "");
    EXPECT_NE(
        test::SceneText(test::header + mesh("a.x"), folder, {{}, formats}).messages().find(".pmf or .dot"),
        std::string::npos);
}

} // namespace
} // namespace yarte
