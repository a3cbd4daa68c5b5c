// yarte/LANGUAGE.md agrees with the sources.
#include "tests/lang/read_text.h"

#include "yarte/lang/directive.h"

#include <gtest/gtest.h>

#include <regex>
#include <set>

namespace yarte {
namespace fs = std::filesystem;
namespace {

const fs::path sourceFolder = fs::path(YARTE_SOURCE_DIR) / "yarte";

std::string manual() { return readFile(sourceFolder / "LANGUAGE.md"); }

/// The first groups of all matches, each once.
std::set<std::string> findAll(const std::string& text, const char* pattern) {
    const std::regex regex(pattern);
    std::set<std::string> found;
    for (std::sregex_iterator match(text.begin(), text.end(), regex), end; match != end; ++match)
        found.insert((*match)[1]);
    return found;
}

TEST(Manual, ListsEveryDiagnosticsCodeOfTheSources) {
    std::set<std::string> codes;
    for (const char* folder : {"base", "scene", "lang"})
        for (const auto& entry : fs::directory_iterator(sourceFolder / folder))
            if (entry.path().extension() == ".cpp")
                codes.merge(findAll(readFile(entry), R"re("((?:lang|scene|pmf)\.[a-z-]+)")re"));
    EXPECT_GT(codes.size(), 40U);
    EXPECT_EQ(findAll(manual(), R"re(\n\| `([a-z]+\.[a-z-]+)` \|)re"), codes);
}

TEST(Manual, EveryCodeHasAGoldenDiagnostic) {
    std::set<std::string> shown;
    for (const auto& entry :
         fs::directory_iterator(fs::path(YARTE_SOURCE_DIR) / "tests" / "data" / "lang" / "bad"))
        if (entry.path().extension() == ".expected")
            shown.merge(findAll(readFile(entry), R"re( \[([a-z.-]+)\]\n)re"));
    // What no text can bring about, or no small one.
    shown.insert({"pmf.too-large", "pmf.unreadable", "scene.index-out-of-range", "scene.not-finite"});
    EXPECT_EQ(shown, findAll(manual(), R"re(\n\| `([a-z]+\.[a-z-]+)` \|)re"));
}

TEST(Manual, DescribesEveryDirective) {
    const std::string text = manual();
    for (const Directive& directive : directives())
        EXPECT_NE(text.find(std::string("`").append(directive.name)), std::string::npos) << directive.name;
}

TEST(Manual, ExamplesAreGoodScenes) {
    const std::set<std::string> examples = findAll(manual(), R"re(```yarte\n([^`]*)```)re");
    ASSERT_FALSE(examples.empty());
    for (const std::string& example : examples) EXPECT_EQ(test::SceneText(example).messages(), "");
}

} // namespace
} // namespace yarte
