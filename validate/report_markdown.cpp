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

std::string row(const CaseReport& c) {
    const std::string size = c.width > 0 ? fmt::format("{}x{}", c.width, c.height) : "";
    const std::string first = fmt::format("| {} | {} | {} |", name(c.verdict), cell(c.name), size);
    if (!c.comparison) return fmt::format("{} {} | | | | | |\n", first, cell(c.message));
    const Comparison& found = *c.comparison;
    const auto ratio = speedRatio(c);
    return fmt::format("{} {} | {} | {:.6f} | {} | {} | {} |\n", first, errorText(found.maxAbs.value),
                       found.pixelsOver, found.flip.mean, secondsText(c.yarte.trace),
                       secondsText(c.povray.trace), ratio ? fmt::format("{:.1f}x", *ratio) : "");
}

} // namespace

std::string markdownReport(const Report& report) {
    std::string text =
        fmt::format("**{}**\n\n"
                    "| verdict | case | size | max error | px over | FLIP mean | YARTE | POV-Ray | ratio |\n"
                    "|---|---|---|---|---|---|---|---|---|\n",
                    summaryLine(report));
    for (const CaseReport& c : report.cases) text += row(c);
    return text + "\nErrors in linear light; times are trace times.\n";
}

} // namespace yarte::validate
