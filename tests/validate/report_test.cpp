#include "tests/validate/support.h"
#include "validate/program.h"
#include "validate/report_html.h"
#include "validate/report_json.h"
#include "validate/report_junit.h"
#include "validate/report_markdown.h"
#include "validate/report_text.h"

#include <gmock/gmock.h>

namespace yarte::validate {
namespace {

using test::sampleReport;
using test::scratchFolder;
using testing::HasSubstr;
using testing::Not;

std::string expected(const std::string& name) {
    return readFile(std::filesystem::path(YARTE_SOURCE_DIR) / "tests/validate/data" / name);
}

TEST(Report, Json) { EXPECT_EQ(jsonReport(sampleReport()), expected("report.json")); }

TEST(Report, Markdown) { EXPECT_EQ(markdownReport(sampleReport()), expected("summary.md")); }

TEST(Report, Junit) { EXPECT_EQ(junitReport(sampleReport()), expected("junit.xml")); }

TEST(Report, JunitIsWellFormedXml) {
    const auto xmllint = findProgram("xmllint", {"/usr/bin", "/usr/local/bin"});
    if (!xmllint) GTEST_SKIP() << "skipped: no xmllint";
    const auto folder = scratchFolder();
    writeFile(folder / "junit.xml", junitReport(sampleReport()));
    const StopSignal stop;
    const std::string counts =
        "count(//testcase) = //testsuite/@tests and count(//failure) = //testsuite/@failures "
        "and count(//error) = //testsuite/@errors";
    for (const std::string& test : {counts, std::string("contains(//error, '</script> & \"quotes\"')")}) {
        const ProgramResult result = run(
            {{"/bin/sh", "-c", "\"$0\" --xpath \"$1\" junit.xml >&2", *xmllint, test}, folder, {}, 60, 0, 0},
            stop);
        EXPECT_EQ(result.errorText, "true\n") << test;
    }
}

TEST(Report, ConsoleLines) {
    const Report report = sampleReport();
    EXPECT_EQ(caseLine(report.cases[0]),
              "pass   paper  256x128  max 0.49/65535  0 px over  yarte 0.12 s  povray 0.75 s (6.0x)");
    EXPECT_EQ(caseLine(report.cases[1]),
              "fail   glass  256x128  max 0.49/65535  2 px over  yarte 0.12 s  povray ?");
    EXPECT_EQ(caseLine(report.cases[2]),
              "error  broken  yarte: exit code 1\n       </script> & \"quotes\" | pipes");
    EXPECT_EQ(summaryLine(report), "3 cases: 1 pass, 1 fail, 1 error");
}

TEST(Report, TheWorstVerdictCounts) {
    Report report = sampleReport();
    EXPECT_EQ(report.verdict(), Verdict::error);
    report.cases.pop_back();
    EXPECT_EQ(report.verdict(), Verdict::fail);
    report.cases.pop_back();
    EXPECT_EQ(report.verdict(), Verdict::pass);
}

TEST(Report, TheHtmlPageNeedsNothingElse) {
    const auto folder = scratchFolder();
    std::filesystem::create_directories(folder / "images/paper");
    writeFile(folder / "images/paper/yarte.png", "foobar");
    const std::string html = htmlReport(sampleReport(), folder);
    EXPECT_THAT(html, HasSubstr("\"images/paper/yarte.png\": \"data:image/png;base64,Zm9vYmFy\""));
    EXPECT_THAT(html, HasSubstr("\\u003c/script> & \\\"quotes\\\""));
    for (const char* forbidden : {"http:", "https:", "src=\"", "@import", "url(", "/*style*/", "/*script*/",
                                  "/*report*/", "/*pictures*/"})
        EXPECT_THAT(html, Not(HasSubstr(forbidden)));
}

TEST(Json, NumbersOfAnObject) {
    EXPECT_EQ(numberInJson(R"({"a": {"trace_s": 1}, "trace_s": 0.25})", "trace_s"), 0.25);
    EXPECT_EQ(numberInJson(R"({"trace_s": "0.25"})", "trace_s"), std::nullopt);
    EXPECT_EQ(numberInJson(R"({"wall_s": 1})", "trace_s"), std::nullopt);
    for (const char* text : {"", "[1]", "{\"trace_s\": 1", "\xff"})
        EXPECT_EQ(numberInJson(text, "trace_s"), std::nullopt) << text;
}

} // namespace
} // namespace yarte::validate
