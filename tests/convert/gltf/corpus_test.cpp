// glTF that others wrote: every asset opens or is refused by name, and no broken file does worse than an error.
#include "tests/convert/gltf/support.h"

#include "yarte/lang/pmf.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <set>

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

/// "/nodes/3/mesh" as the ledger has it: "/nodes/*/mesh".
std::string generalised(const std::string& pointer) {
    std::string result;
    std::size_t begin = 0;
    while (begin < pointer.size()) {
        const std::size_t end = std::min(pointer.find('/', begin + 1), pointer.size());
        const std::string step = pointer.substr(begin + 1, end - begin - 1);
        const bool isIndex = !step.empty() && step.find_first_not_of("0123456789") == std::string::npos;
        result += "/" + (isIndex ? "*" : step);
        begin = end;
    }
    return result;
}

/// Nothing is lost silently: every value of the JSON, or an object or array that holds it, has a row.
TEST(GltfCorpus, EveryPropertyOfEveryAssetIsInTheLedger) {
    const auto files = filesBelow("gltf");
    if (files.empty()) GTEST_SKIP() << "YARTE_CORPORA names no folder with glTF";
    std::size_t checked = 0;
    for (const fs::path& file : files) {
        if (file.extension() != ".gltf") continue;
        const Converted run(options(file, "out.yarte"));
        if (run.files.empty()) continue;
        std::set<std::string> told;
        for (const LedgerRow& row : run.ledger.rows())
            told.insert((row.where == "/" ? "" : generalised(row.where)) + "/" + row.property);
        const auto json = nlohmann::json::parse(readFile(file)).flatten();
        for (const auto& [pointer, value] : json.items()) {
            const std::string place = generalised(pointer);
            bool found = false;
            for (std::size_t end = place.size(); !found && end != 0 && end != std::string::npos;
                 end = place.rfind('/', end - 1))
                found = told.contains(place.substr(0, end));
            EXPECT_TRUE(found) << file << ": " << pointer << " is in no row";
            ++checked;
        }
    }
    EXPECT_GT(checked, 10000u);
}

/// glTF -> YARTE -> glTF keeps the picture: what is read back is the same scene.
TEST(GltfCorpus, EveryAssetIsTheSameSceneAfterAnotherRound) {
    const auto files = filesBelow("gltf");
    if (files.empty()) GTEST_SKIP() << "YARTE_CORPORA names no folder with glTF";
    for (const fs::path& file : files) {
        Sources sources;
        Diagnostics diagnostics;
        Ledger ledger;
        Conversion c{{sources.add(file, readFile(file)), file, {}}, {}, {}, sources, diagnostics, ledger};
        const auto scene = gltf::readScene(c);
        if (!scene) continue;
        const ReadGltf back(written(*scene, true));
        ASSERT_TRUE(back.scene) << file << '\n' << back.problems();
        EXPECT_EQ(printScene(*back.scene), printScene(*scene)) << file;
        ASSERT_EQ(back.scene->meshes.size(), scene->meshes.size()) << file;
        for (std::size_t i = 0; i < scene->meshes.size(); ++i)
            EXPECT_TRUE(printPmf(back.scene->meshes[i]) == printPmf(scene->meshes[i])) << file << ": mesh " << i;
    }
}

} // namespace
} // namespace yarte::convert::test
