#include "validate/report_junit.h"

#include "validate/report_text.h"
#include "validate/text.h"

#include <fmt/format.h>

namespace yarte::validate {

namespace {

double seconds(const CaseReport& report) {
    double sum = 0;
    for (const CommandRecord& command : report.commands) sum += command.seconds;
    return sum;
}

double seconds(const Report& report) {
    double sum = 0;
    for (const CaseReport& c : report.cases) sum += seconds(c);
    return sum;
}

std::string commandLines(const CaseReport& report) {
    std::string lines;
    for (const CommandRecord& command : report.commands) lines += command.line + "\n";
    return lines;
}

std::string problemText(const CaseReport& report) {
    std::string text = report.message;
    for (const Finding& finding : causes(report)) text += fmt::format("\n{}", finding.explanation);
    return text;
}

std::string problem(const CaseReport& report) {
    if (report.verdict == Verdict::pass) return {};
    const char* const element = report.verdict == Verdict::fail ? "failure" : "error";
    const std::string firstLine = report.message.substr(0, report.message.find('\n'));
    return fmt::format("      <{0} message=\"{1}\" type=\"{2}\">{3}</{0}>\n", element, markupText(firstLine),
                       name(report.verdict), markupText(problemText(report)));
}

} // namespace

std::string junitReport(const Report& report) {
    const std::string counts =
        fmt::format("tests=\"{}\" failures=\"{}\" errors=\"{}\" time=\"{:.3f}\"", report.cases.size(),
                    report.count(Verdict::fail), report.count(Verdict::error), seconds(report));
    std::string xml = fmt::format("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites {0}>\n"
                                  "  <testsuite name=\"yarte-validate\" {0} skipped=\"0\">\n",
                                  counts);
    for (const CaseReport& c : report.cases)
        xml += fmt::format(
            "    <testcase classname=\"yarte-validate\" name=\"{}\" file=\"{}\" time=\"{:.3f}\">\n{}"
            "      <system-out>{}</system-out>\n    </testcase>\n",
            markupText(c.name), markupText(c.source), seconds(c), problem(c),
            markupText(caseLine(c) + "\n" + commandLines(c)));
    return xml + "  </testsuite>\n</testsuites>\n";
}

} // namespace yarte::validate
