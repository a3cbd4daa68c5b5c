#include "validate/report_markdown.h"

#include "validate/report_text.h"

#include <fmt/format.h>

namespace yarte::validate {

namespace {

/// In a table's cell: one line, nothing that Markdown or HTML would take for its own.
std::string cell(std::string_view text) {
    std::string result;
    for (const char c : text.substr(0, text.find('\n'))) {
        if (c == '<')
            result += "&lt;";
        else if (c == '&')
            result += "&amp;";
        else {
            if (std::string_view("|\\`*_[]").find(c) != std::string_view::npos) result += '\\';
            result += c;
        }
    }
    return result;
}

std::string sizeText(const CaseReport& c) {
    return c.width > 0 ? fmt::format("{}x{}", c.width, c.height) : "";
}

/// A case that is not a pass: what is wrong with it.
std::string problemRow(const CaseReport& c) {
    const std::vector<Finding> found = causes(c);
    const std::string why = found.empty() ? c.message : found.front().explanation;
    const std::string numbers =
        c.comparison ? fmt::format("{} | {}", errorText(c.comparison->maxAbs.value), c.comparison->pixelsOver)
                     : " | ";
    return fmt::format("| {} | {} | {} | {} | {} |\n", name(c.verdict), cell(c.name), sizeText(c), numbers,
                       cell(why));
}

std::string passRow(const CaseReport& c) {
    const auto ratio = speedRatio(c);
    return fmt::format("| {} | {} | {} | {} | {} | {} |\n", cell(c.name), sizeText(c),
                       c.comparison ? errorText(c.comparison->maxAbs.value) : "", secondsText(c.yarte.trace),
                       secondsText(c.povray.trace), ratio ? fmt::format("{:.1f}x", *ratio) : "");
}

/// A table of the cases that are, or are not, a pass, at most `length` bytes of rows; empty without one.
template <class Row>
std::string table(const Report& report, bool passes, const char* head, std::size_t length, const Row& row) {
    std::string rows;
    std::size_t left = 0;
    for (const CaseReport& c : report.cases) {
        if ((c.verdict == Verdict::pass) != passes) continue;
        if (left == 0 && rows.size() < length)
            rows += row(c);
        else
            ++left;
    }
    if (rows.empty()) return {};
    return fmt::format("{}{}{}\n", head, rows,
                       left > 0 ? fmt::format("\n... and {} more: see index.html\n", left) : "");
}

} // namespace

std::string markdownReport(const Report& report) {
    constexpr std::size_t problems = 30'000, passes = 20'000; // GitHub takes 65,536 characters as a comment
    std::string text = fmt::format("**{}**\n\n", summaryLine(report));
    text += table(report, false,
                  "| verdict | case | size | max error | px over | cause |\n|---|---|---|---|---|---|\n",
                  problems, problemRow);
    const std::string passed = table(
        report, true, "| case | size | max error | YARTE | POV-Ray | ratio |\n|---|---|---|---|---|---|\n",
        passes, passRow);
    if (!passed.empty())
        text += fmt::format("<details><summary>{} pass</summary>\n\n{}</details>\n\n",
                            report.count(Verdict::pass), passed);
    text += "Errors in linear light; times are trace times";
    return text + (report.jobs > 1 ? fmt::format(" of {} cases side by side.\n", report.jobs) : ".\n");
}

} // namespace yarte::validate
