#include "validate/report_annotations.h"

#include "yarte/base/number.h"

#include <algorithm>
#include <fmt/format.h>
#include <optional>
#include <vector>

namespace yarte::validate {

namespace {

std::string replaced(std::string_view text, std::string_view special) {
    std::string result;
    for (const char c : text)
        if (special.find(c) != std::string_view::npos)
            result += fmt::format("%{:02X}", static_cast<unsigned char>(c));
        else
            result += c;
    return result;
}

std::string asData(std::string_view text) { return replaced(text, "%\r\n"); }
std::string asProperty(std::string_view text) { return replaced(text, "%\r\n:,"); }

std::string shownFrom(const std::filesystem::path& root, const std::string& file) {
    const auto absolute = [](const std::filesystem::path& path) {
        return std::filesystem::absolute(path).lexically_normal();
    };
    const auto relative = absolute(file).lexically_relative(absolute(root));
    return relative.empty() || *relative.begin() == ".." ? file : relative.generic_string();
}

/// The number in "...:LINE:COLUMN: error: ...", as the programs write it.
std::optional<int> lineIn(std::string_view message) {
    const std::size_t end = message.find(": error: ");
    if (end == std::string_view::npos) return std::nullopt;
    const std::size_t column = message.rfind(':', end - 1);
    if (column == std::string_view::npos || column == 0) return std::nullopt;
    const std::size_t line = message.rfind(':', column - 1);
    if (line == std::string_view::npos) return std::nullopt;
    const ParsedNumber number = parseNumber(message.substr(line + 1, column - line - 1));
    return number.error || number.value < 1 ? std::nullopt : std::optional(static_cast<int>(number.value));
}

std::string annotation(const CaseReport& c, const std::filesystem::path& root, int line,
                       const std::string& text) {
    return fmt::format("::error file={},line={},title={}::{}\n", asProperty(shownFrom(root, c.source)), line,
                       asProperty(fmt::format("{}: {}", c.name, name(c.verdict))), asData(text));
}

} // namespace

std::string githubAnnotations(const Report& report, const std::filesystem::path& root) {
    std::string text;
    for (const CaseReport& c : report.cases) {
        if (c.verdict == Verdict::pass) continue;
        const std::vector<Finding> found = causes(c);
        for (const Finding& finding : found)
            text += annotation(c, root, std::max(finding.line, 1),
                               fmt::format("{} ({})", finding.explanation, c.message));
        if (found.empty()) text += annotation(c, root, lineIn(c.message).value_or(1), c.message);
    }
    return text;
}

} // namespace yarte::validate
