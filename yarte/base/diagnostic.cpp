#include "yarte/base/diagnostic.h"

#include "yarte/base/diagnostic_json.h"
#include "yarte/base/excerpt.h"
#include "yarte/base/text.h"

#include <fmt/format.h>

#include <utility>

namespace yarte {
namespace {

// Select Graphic Rendition (ECMA-48).
constexpr std::string_view bold = "\x1b[1m", red = "\x1b[1;31m", magenta = "\x1b[1;35m", cyan = "\x1b[1;36m",
                           green = "\x1b[1;32m", reset = "\x1b[0m";

class TextFormatter {
public:
    TextFormatter(const Sources& sources, bool coloured) : sources_(sources), coloured_(coloured) {}

    std::string format(const Diagnostic& d) const {
        std::string text = entry(d.severity, d.message, d.code, d.span, d.file);
        for (const DiagnosticNote& note : d.notes)
            text += entry(Severity::note, note.message, {}, note.span, {});
        return text;
    }

private:
    std::string paint(std::string_view colour, std::string text) const {
        return coloured_ ? fmt::format("{}{}{}", colour, text, reset) : text;
    }

    std::string entry(Severity severity, std::string_view message, std::string_view code, Span span,
                      std::string_view file) const {
        std::string text;
        if (span.source.valid()) {
            const Source& source = sources_[span.source];
            const LineColumn at = source.position(span.begin);
            text = paint(bold, fmt::format("{}:{}:{}: ", printable(source.name()), at.line, at.column));
        } else if (!file.empty())
            text = paint(bold, printable(file) + ": ");
        const std::string_view colour = severity == Severity::error     ? red
                                        : severity == Severity::warning ? magenta
                                                                        : cyan;
        text += paint(colour, fmt::format("{}: ", severityName(severity))) + paint(bold, printable(message));
        if (!code.empty()) text += fmt::format(" [{}]", code);
        text += '\n';
        if (span.source.valid()) {
            const auto [line, marks] = excerpt(sources_[span.source], span);
            text += fmt::format("    {}\n    {}\n", line, paint(green, marks));
        }
        return text;
    }

    const Sources& sources_;
    bool coloured_;
};

} // namespace

std::string_view severityName(Severity severity) {
    switch (severity) {
    case Severity::note: return "note";
    case Severity::warning: return "warning";
    case Severity::error: break;
    }
    return "error";
}

Diagnostic& Diagnostics::error(std::string_view code, std::string message, Span span) {
    ++errorCount_;
    return add(Severity::error, code, std::move(message), span);
}

Diagnostic& Diagnostics::warning(std::string_view code, std::string message, Span span) {
    return add(Severity::warning, code, std::move(message), span);
}

Diagnostic& Diagnostics::add(Severity severity, std::string_view code, std::string message, Span span) {
    Diagnostic& place = full() ? notKept_ : diagnostics_.emplace_back();
    return place = {severity, code, std::move(message), span, {}, {}};
}

std::string format(const Diagnostics& diagnostics, const Sources& sources, DiagnosticStyle style) {
    Diagnostic closing;
    closing.severity = Severity::note;
    closing.message = fmt::format("there are more errors; the first {} are shown", Diagnostics::maxErrors);
    const auto one = [&](const Diagnostic& d) {
        return style == DiagnosticStyle::json
                   ? formatJson(d, sources) + '\n'
                   : TextFormatter(sources, style == DiagnosticStyle::coloured).format(d);
    };
    std::string text;
    for (const Diagnostic& d : diagnostics.all()) text += one(d);
    if (diagnostics.full()) text += one(closing);
    return text;
}

} // namespace yarte
