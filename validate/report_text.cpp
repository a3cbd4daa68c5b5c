#include "validate/report_text.h"

#include <fmt/format.h>

namespace yarte::validate {

namespace {

/// Later lines of a message are indented, so that each case begins at the left.
std::string indented(const std::string& message) {
    std::string text;
    for (const char c : message) {
        text += c;
        if (c == '\n') text += "       ";
    }
    return text;
}

} // namespace

std::string errorText(double value) {
    const double steps = value * 65535;
    return steps < 1000 ? fmt::format("{:.2f}/65535", steps) : fmt::format("{:.4g}", value);
}

std::string secondsText(const std::optional<double>& seconds) {
    if (!seconds) return "?";
    return *seconds < 0.1 ? fmt::format("{:.3f} s", *seconds) : fmt::format("{:.2f} s", *seconds);
}

std::string caseLine(const CaseReport& c) {
    std::string line = fmt::format("{:<5}  {}", name(c.verdict), c.name);
    if (c.width > 0) line += fmt::format("  {}x{}", c.width, c.height);
    if (!c.comparison) return line + "  " + indented(c.message);
    line +=
        fmt::format("  max {}  {} px over", errorText(c.comparison->maxAbs.value), c.comparison->pixelsOver);
    if (c.yarte.wall) line += fmt::format("  yarte {}", secondsText(c.yarte.trace));
    if (c.povray.wall) line += fmt::format("  povray {}", secondsText(c.povray.trace));
    if (const auto ratio = speedRatio(c)) line += fmt::format(" ({:.1f}x)", *ratio);
    for (const Finding& finding : causes(c)) line += "\n       " + finding.explanation;
    return line;
}

std::string summaryLine(const Report& report) {
    return fmt::format("{} case{}: {} pass, {} fail, {} error", report.cases.size(),
                       report.cases.size() == 1 ? "" : "s", report.count(Verdict::pass),
                       report.count(Verdict::fail), report.count(Verdict::error));
}

} // namespace yarte::validate
