#include "tests/validate/support.h"
#include "validate/program.h"
#include "validate/report_annotations.h"
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

TEST(Report, JsonFitsItsSchemaAndWhatDoesNotIsNoticed) {
    const auto python = findProgram("python3", {"/usr/bin", "/usr/local/bin"});
    if (!python) GTEST_SKIP() << "skipped: no python3";
    const auto folder = scratchFolder();
    const std::filesystem::path root = YARTE_SOURCE_DIR;
    const StopSignal stop;
    const auto errorsOf = [&](const std::string& json) {
        writeFile(folder / "report.json", json);
        return run({{"/bin/sh", "-c", "\"$@\" >&2", "sh", *python, root / "tests/validate/check_schema.py",
                     root / "validate/report.schema.json", "report.json"},
                    folder,
                    {},
                    60,
                    0,
                    0},
                   stop)
            .errorText;
    };
    const std::string json = jsonReport(sampleReport());
    EXPECT_EQ(errorsOf(json), "");
    const auto changed = [&](const std::string& from, const std::string& to) {
        std::string text = json;
        return text.replace(text.find(from), from.size(), to);
    };
    EXPECT_EQ(errorsOf(changed("\"verdict\": \"pass\"", "\"verdict\": \"good\"")),
              "report.json/cases/0/verdict: 'good' is none of ['pass', 'fail', 'error']\n");
    EXPECT_EQ(errorsOf(changed("\"width\": 256", "\"width\": -1")),
              "report.json/cases/0/width: -1 is below 0\n");
    EXPECT_EQ(errorsOf(changed("\"jobs\": 2", "\"cores\": 2")),
              "report.json: jobs is missing\nreport.json: cores is not in the schema\n");
    EXPECT_EQ(errorsOf(changed("\"cause\": \"body\"", "\"cause\": \"bodies\"")),
              "report.json/cases/1/cause: fits none of the alternatives\n");
}

TEST(Report, Annotations) {
    Report report = sampleReport();
    EXPECT_EQ(githubAnnotations(report, std::filesystem::current_path()),
              "::error file=scenes/paper/paper.yarte,line=23,title=glass%3A fail::the sphere at line 23 is "
              "missing or "
              "moved (2 of 32768 pixels differ)\n"
              "::error file=a|b & <c>.yarte,line=1,title=broken%3A error::yarte: exit code 1%0A</script> & "
              "\"quotes\" | pipes\n");
    report.cases[2].source = "/elsewhere/50%,1:2.yarte";
    EXPECT_THAT(githubAnnotations(report, std::filesystem::current_path()),
                HasSubstr("::error file=/elsewhere/50%25%2C1%3A2.yarte,line=1,"));
}

TEST(Report, TheSummaryFitsIntoAComment) {
    Report report = sampleReport();
    report.cases[1].explanation.common->explanation = std::string(2000, 'x');
    for (int i = 0; i < 1000; ++i) {
        report.cases.push_back(report.cases[0]);
        report.cases.push_back(report.cases[1]);
    }
    EXPECT_LT(markdownReport(report).size(), 60'000u);
    EXPECT_THAT(markdownReport(report), HasSubstr("more: see index.html"));
}

TEST(Report, ConsoleLines) {
    const Report report = sampleReport();
    EXPECT_EQ(caseLine(report.cases[0]),
              "pass   paper  256x128  max 0.49/65535  0 px over  yarte 0.12 s  povray 0.75 s (6.0x)");
    EXPECT_EQ(caseLine(report.cases[1]),
              "fail   glass  256x128  max 0.49/65535  2 px over  yarte 0.12 s  povray ?\n"
              "       the sphere at line 23 is missing or moved");
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
    Report report = sampleReport();
    report.cases[0].page = {2, 1, 1, 0, 1, "foobar", "foobarfoo", "foo", "foobar"};
    const std::string html = htmlReport(report);
    EXPECT_THAT(html, HasSubstr("\"unit\": 1, \"thumbnail\": \"data:image/png;base64,Zm9vYmFy\"}"));
    EXPECT_THAT(html,
                HasSubstr("<script type=\"text/plain\" id=\"pixels-0\">Zm9vYmFy Zm9vYmFyZm9v Zm9v</script>"));
    EXPECT_THAT(html, Not(HasSubstr("id=\"pixels-1\"")));
    EXPECT_THAT(html, HasSubstr("\\u003c/script> & \\\"quotes\\\""));
    for (const char* forbidden : {"http:", "https:", "src=\"", "@import", "url(", "/*style*/", "/*script*/",
                                  "/*report*/", "/*pages*/", "/*pixels*/"})
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
