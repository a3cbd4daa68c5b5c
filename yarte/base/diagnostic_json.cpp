#include "yarte/base/diagnostic_json.h"

#include "yarte/base/json.h"

#include <fmt/format.h>

namespace yarte {
namespace {

/// `, "file": …, "line": …` as far as they are known.
std::string placeFields(Span span, const std::string& file, const Sources& sources) {
    if (!span.source.valid()) return file.empty() ? "" : ", \"file\": " + jsonString(file);
    const Source& source = sources[span.source];
    const LineColumn begin = source.position(span.begin), end = source.position(span.end);
    return fmt::format(R"(, "file": {}, "line": {}, "column": {}, "endLine": {}, "endColumn": {})",
                       jsonString(source.name()), begin.line, begin.column, end.line, end.column);
}

} // namespace

std::string formatJson(const Diagnostic& d, const Sources& sources) {
    std::string notes;
    for (const DiagnosticNote& note : d.notes)
        notes += fmt::format(R"({}{{"message": {}{}}})", notes.empty() ? "" : ", ", jsonString(note.message),
                             placeFields(note.span, {}, sources));
    return fmt::format(R"({{"severity": "{}", "code": {}, "message": {}{}, "notes": [{}]}})",
                       severityName(d.severity), jsonString(d.code), jsonString(d.message),
                       placeFields(d.span, d.file, sources), notes);
}

} // namespace yarte
