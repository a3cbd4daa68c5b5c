// glTF that others wrote: every asset opens or is refused by name, and no broken file does worse than an error.
#include "tests/convert/gltf/support.h"
#include "tests/support/program.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace yarte::convert::test {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> filesBelow(const std::string& folder) {
    std::vector<fs::path> files;
    if (std::string(YARTE_CORPORA).empty()) return files;
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(YARTE_CORPORA) / folder))
        if (entry.path().extension() == ".gltf" || entry.path().extension() == ".glb") files.push_back(entry);
    std::ranges::sort(files);
    return files;
}

/// Reads in this process: what goes wrong here would be seen as a crash of the test.
void expectOpensOrIsRefused(const fs::path& file, bool onlyByExtension) {
    Converted run(options(file, "out.yarte"));
    if (!run.files.empty()) return;
    const std::string problems = run.problems();
    EXPECT_NE(problems.find("error: "), std::string::npos) << file << ": neither read nor an error";
    if (onlyByExtension) {
        EXPECT_NE(problems.find("[gltf.extension-required]"), std::string::npos) << file << '\n' << problems;
    }
}

TEST(GltfCorpus, EveryAssetOpensOrIsRefusedByTheNameOfAnExtension) {
    const auto files = filesBelow("gltf");
    if (files.empty()) GTEST_SKIP() << "YARTE_CORPORA names no folder with glTF";
    EXPECT_GE(files.size(), 50u);
    for (const fs::path& file : files) expectOpensOrIsRefused(file, true);
}

TEST(GltfCorpus, BrokenFilesAreReadOrRefusedWithAPlace) {
    const auto files = filesBelow("gltf-validator-cases");
    if (files.empty()) GTEST_SKIP() << "YARTE_CORPORA names no folder with glTF";
    EXPECT_GE(files.size(), 100u);
    for (const fs::path& file : files) expectOpensOrIsRefused(file, false);
}

} // namespace
} // namespace yarte::convert::test
