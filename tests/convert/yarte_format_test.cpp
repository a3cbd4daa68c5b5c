// .yarte to .yarte: what becomes of the mesh files.
#include "convert/yarte_format.h"
#include "tests/convert/support.h"
#include "tests/support/program.h"
#include "yarte/lang/pmf.h"
#include "yarte/lang/scene_reader.h"

#include <gtest/gtest.h>

namespace yarte::convert::test {
namespace {

constexpr MeshFormat meshFormats[] = {{".pmf", readPmf}};

Scene sceneIn(const std::filesystem::path& file) {
    Sources sources;
    Diagnostics diagnostics;
    auto scene = readScene(file, {{}, meshFormats}, sources, diagnostics);
    EXPECT_TRUE(scene) << format(diagnostics, sources, DiagnosticStyle::plain);
    return scene.value_or(Scene{});
}

/// A copy of the golden scene with its meshes in a folder of its own.
std::filesystem::path sceneInFolder() {
    const std::filesystem::path folder = yarte::test::emptyTestFolder();
    for (const char* name : {"meshes.yarte", "flat.pmf", "smooth.pmf"})
        std::filesystem::copy_file(goldenFolder / name, folder / name);
    return folder;
}

void writeAll(const Converted& run) {
    for (const OutputFile& file : run.files) writeFile(file.file, file.bytes);
}

TEST(YarteFormat, WritesTheMeshesBesideTheScene) {
    const std::filesystem::path folder = yarte::test::emptyTestFolder();
    const Converted run(options(goldenFolder / "meshes.yarte", folder / "my scene.yarte"));
    ASSERT_EQ(run.files.size(), 3U) << run.problems();
    writeAll(run);
    EXPECT_EQ(yarte::test::namesIn(folder),
              (std::vector<std::string>{"my scene.yarte", "my_scene.1.pmf", "my_scene.2.pmf"}));
    Scene expected = sceneIn(goldenFolder / "meshes.yarte");
    expected.meshes[0].path = "my_scene.1.pmf", expected.meshes[1].path = "my_scene.2.pmf";
    EXPECT_EQ(sceneIn(folder / "my scene.yarte"), expected);
    EXPECT_FALSE(run.ledger.hasLoss());
}

TEST(YarteFormat, KeepsMeshesThatAreInPlace) {
    const std::filesystem::path folder = sceneInFolder();
    const Converted run(options(folder / "meshes.yarte", folder / "copy.yarte"));
    ASSERT_EQ(run.files.size(), 1U) << run.problems();
    writeAll(run);
    EXPECT_EQ(sceneIn(folder / "copy.yarte"), sceneIn(folder / "meshes.yarte"));
}

TEST(YarteFormat, KeepsALoneMeshThatIsInPlace) {
    const std::filesystem::path folder = sceneInFolder();
    const Converted run(options(folder / "flat.pmf", folder / "flat.yarte"));
    ASSERT_EQ(run.files.size(), 1U) << run.problems();
    writeAll(run);
    EXPECT_EQ(sceneIn(folder / "flat.yarte").meshes[0].path, "flat.pmf");
}

TEST(YarteFormat, KeepsThePathsInCanonicalText) {
    Options canonical = options(goldenFolder / "meshes.yarte", "elsewhere/canonical.yarte");
    canonical.writing.canonical = true;
    const Converted run(canonical);
    ASSERT_EQ(run.files.size(), 1U);
    EXPECT_NE(run.files[0].bytes.find("mesh flat.pmf"), std::string::npos);
}

TEST(YarteFormat, CanonicalTextOfCanonicalTextIsTheSame) {
    const std::filesystem::path folder = sceneInFolder();
    Options canonical = options(folder / "meshes.yarte", folder / "canonical.yarte");
    canonical.writing.canonical = true;
    const Converted first(canonical);
    writeAll(first);
    canonical.input = folder / "canonical.yarte";
    const Converted second(canonical);
    ASSERT_EQ(second.files.size(), 1U) << second.problems();
    EXPECT_EQ(second.files[0].bytes, first.files[0].bytes);
}

} // namespace
} // namespace yarte::convert::test
