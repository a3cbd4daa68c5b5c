// Diagnostics: what is wrong with an input, and where. Readers collect them; only a program's main prints.
#pragma once

#include "yarte/base/source.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace yarte {

enum class Severity { note, warning, error };

/// A second place that explains a diagnostic ("first given here").
struct DiagnosticNote {
    std::string message;
    Span span;
};

struct Diagnostic {
    Severity severity = Severity::error;
    std::string_view code; ///< stable, kebab-case, e.g. "scene.radius-not-positive"; a literal
    std::string message;   ///< one sentence, lower case, no full stop
    Span span;             ///< where; without a valid source, `file` alone tells
    std::string file;      ///< a file without a text to point into (missing, binary); else empty
    std::vector<DiagnosticNote> notes;
};

/// The diagnostics of one run. Keeps at most `maxErrors` errors; readers stop when `full()`.
class Diagnostics {
public:
    static constexpr int maxErrors = 20;

    Diagnostic& error(std::string_view code, std::string message, Span span = {});
    Diagnostic& warning(std::string_view code, std::string message, Span span = {});

    bool hasErrors() const { return errorCount_ > 0; }
    bool full() const { return errorCount_ >= maxErrors; }
    const std::vector<Diagnostic>& all() const { return diagnostics_; }

private:
    Diagnostic& add(Severity severity, std::string_view code, std::string message, Span span);

    std::vector<Diagnostic> diagnostics_;
    int errorCount_ = 0;
};

enum class DiagnosticStyle { plain, coloured, json };

/// All diagnostics as text, each as
///
///     scene.yarte:12:9: error: radius must be positive, got -2 [scene.radius-not-positive]
///         sphere 0 0 0 -2
///                      ^~
///
/// or, in JSON, one object per line: severity, code, message, file, line, column, endLine, endColumn, notes.
std::string format(const Diagnostics&, const Sources&, DiagnosticStyle);

} // namespace yarte
