// tests/data/lang: in good/ each input lies beside its canonical text, in bad/ beside its diagnostics; the
// whole text is compared. Where an .expected.json lies there too, the diagnostics in JSON must be that.
#include "yarte/lang/pmf.h"
#include "yarte/lang/scene_printer.h"
#include "yarte/lang/scene_reader.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>

namespace yarte {
namespace fs = std::filesystem;
namespace {

const fs::path dataFolder = fs::path(YARTE_SOURCE_DIR) / "tests" / "data" / "lang";

struct GoldenCase {
    fs::path file;
    friend std::ostream& operator<<(std::ostream& out, const GoldenCase& c) {
        return out << c.file.filename();
    }
};

std::vector<GoldenCase> casesIn(const char* folder) {
    std::vector<GoldenCase> cases;
    for (const auto& entry : fs::directory_iterator(dataFolder / folder))
        if (entry.path().extension() == ".yarte" ||
            (entry.path().extension() == ".pmf" &&
             fs::exists(fs::path(entry).replace_extension(".pmf.expected"))))
            cases.push_back({entry.path()});
    std::sort(cases.begin(), cases.end(), [](const auto& a, const auto& b) { return a.file < b.file; });
    return cases;
}

std::string caseName(const testing::TestParamInfo<GoldenCase>& info) {
    std::string name = info.param.file.filename().string();
    std::replace_if(
        name.begin(), name.end(), [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); }, '_');
    return name;
}

/// Compares whole; leaves what was got beside the other outputs of the tests.
void expectText(const std::string& got, const fs::path& expected) {
    const std::string want = fs::exists(expected) ? readFile(expected) : "";
    if (got == want) return;
    const fs::path gotFile =
        fs::path(YARTE_TEST_OUTPUT) / "lang" / expected.parent_path().filename() / expected.filename();
    fs::create_directories(gotFile.parent_path());
    writeFile(gotFile, got);
    EXPECT_EQ(got, want) << "got:      " << gotFile.string() << "\nexpected: " << expected.string();
}

/// Reads as if in the file's folder, so that diagnostics name files without a folder.
struct Read {
    explicit Read(const fs::path& file) {
        const fs::path before = fs::current_path();
        fs::current_path(file.parent_path());
        if (file.extension() == ".pmf") {
            if (const auto mesh = readPmf(file.filename(), {}, sources, diagnostics))
                canonical = printPmf(*mesh);
        } else if (const auto scene = readScene(file.filename(), {{}, formats}, sources, diagnostics))
            canonical = printScene(*scene);
        fs::current_path(before);
    }

    static constexpr MeshFormat formats[] = {{".pmf", readPmf}};
    Sources sources;
    Diagnostics diagnostics;
    std::optional<std::string> canonical;
};

class GoodInput : public testing::TestWithParam<GoldenCase> {};

TEST_P(GoodInput, IsReadAndPrintedAsExpected) {
    const fs::path file = GetParam().file;
    const Read read(file);
    EXPECT_EQ(format(read.diagnostics, read.sources, DiagnosticStyle::plain), "");
    ASSERT_TRUE(read.canonical);
    expectText(*read.canonical, file.string() + ".expected");
}

INSTANTIATE_TEST_SUITE_P(Golden, GoodInput, testing::ValuesIn(casesIn("good")), caseName);

class BadInput : public testing::TestWithParam<GoldenCase> {};

TEST_P(BadInput, IsDiagnosedAsExpected) {
    const fs::path file = GetParam().file;
    const Read read(file);
    EXPECT_EQ(read.canonical.has_value(), !read.diagnostics.hasErrors());
    expectText(format(read.diagnostics, read.sources, DiagnosticStyle::plain), file.string() + ".expected");
    if (const fs::path json = file.string() + ".expected.json"; fs::exists(json))
        expectText(format(read.diagnostics, read.sources, DiagnosticStyle::json), json);
}

INSTANTIATE_TEST_SUITE_P(Golden, BadInput, testing::ValuesIn(casesIn("bad")), caseName);

} // namespace
} // namespace yarte
