// What YARTE is built for: no pixel of any scene differs from POV-Ray's by more than 4/65535 in linear light.
// A picture that fails stays in the test's folder: got, expected and difference, with an index.html.
#include "tests/support/povray.h"
#include "tests/support/program.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <ostream>

using namespace yarte;

namespace {

namespace fs = std::filesystem;

struct Case {
    std::string scene; ///< name of its folder
    std::string size;  ///< empty: the scene's own
};

void PrintTo(const Case& c, std::ostream* out) { *out << c.scene << ' ' << c.size; }

std::vector<Case> cases() {
    std::vector<Case> result;
    for (const auto& entry : fs::directory_iterator(fs::path(YARTE_SOURCE_DIR) / "scenes"))
        if (entry.is_directory()) result.push_back({entry.path().filename().string(), ""});
    std::sort(result.begin(), result.end(), [](const Case& a, const Case& b) { return a.scene < b.scene; });
    for (const char* size : {"512x512", "1024x1024"}) result.push_back({"paper", size});
    return result;
}

class PovrayAgreement : public testing::TestWithParam<Case> {};

TEST_P(PovrayAgreement, EveryPixelWithinFourSteps) {
    if (!yarte::test::hasPovray()) GTEST_SKIP() << "skipped: povray not found";
    const fs::path scenes = fs::path(YARTE_SOURCE_DIR) / "scenes", folder = test::emptyTestFolder();
    const auto [scene, size] = GetParam();
    std::vector<std::string> arguments{(scenes / scene / (scene + ".yarte")).string(), "-o", "report"};
    if (!size.empty()) arguments.insert(arguments.end(), {"--size", size});
    const test::ProgramResult result = test::run("yarte-validate", arguments, folder);
    EXPECT_EQ(result.exitCode, 0) << result.out << result.err << "pictures: " << (folder / "report").string();
}

INSTANTIATE_TEST_SUITE_P(Scenes, PovrayAgreement, testing::ValuesIn(cases()), [](const auto& c) {
    std::string name = c.param.scene + (c.param.size.empty() ? "" : "_" + c.param.size);
    std::replace_if(
        name.begin(), name.end(), [](char x) { return !std::isalnum(static_cast<unsigned char>(x)); }, '_');
    return name;
});

TEST(PovrayAgreement, EverySceneIsExpectedToBeEqual) {
    // The strict default is not loosened for any scene of ours.
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(YARTE_SOURCE_DIR) / "scenes"))
        EXPECT_NE(entry.path().filename(), "tolerance.json") << entry.path();
}

/// POV-Ray's own picture of a scene in its language, and ours of what we read of it.
TEST(PovrayAgreement, ImportedGlassIsTintedAsPovraysIs) {
    if (!yarte::test::hasPovray()) GTEST_SKIP() << "skipped: povray not found";
    const fs::path scene = fs::path(YARTE_SOURCE_DIR) / "tests" / "data" / "povray" / "tinted_glass.pov",
                   folder = test::emptyTestFolder();
    const test::ProgramResult result =
        test::run("yarte-validate", {scene.string(), "--size", "160x120", "-o", "report"}, folder);
    EXPECT_EQ(result.exitCode, 0) << result.out << result.err << "pictures: " << (folder / "report").string();
}

} // namespace
