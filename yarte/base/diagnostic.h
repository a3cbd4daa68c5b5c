// Diagnostics: what is wrong with an input, and where. Readers collect them; only a program's main prints.
#pragma once

#include "yarte/base/source.h"

#include <string>
#include <string_view>
#include <vector>

namespace yarte {

enum class Severity { note, warning, error };

std::string_view severityName(Severity);

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

/// The diagnostics of one run. Keeps the first `maxErrors` errors; readers stop when `full()`.
class Diagnostics {
public:
    static constexpr int maxErrors = 20;

    Diagnostic& error(std::string_view code, std::string message, Span span = {});
    Diagnostic& warning(std::string_view code, std::string message, Span span = {});

    bool hasErrors() const { return errorCount_ > 0; }
    /// An error more than are kept has been found: further reading would tell nothing.
    bool full() const { return errorCount_ > maxErrors; }
    const std::vector<Diagnostic>& all() const { return diagnostics_; }

private:
    Diagnostic& add(Severity severity, std::string_view code, std::string message, Span span);

    std::vector<Diagnostic> diagnostics_;
    Diagnostic notKept_; ///< takes what comes after the last error that is kept
    int errorCount_ = 0;
};

enum class DiagnosticStyle { plain, coloured, json };

/// All diagnostics as text, each as
///
///     scene.yarte:12:9: error: radius must be positive, got -2 [scene.radius-not-positive]
///         sphere 0 0 0 -2
///                      ^~
///
/// or, in JSON, one object per line: severity, code, message, file, line, column, endLine, endColumn (one
/// past the last), notes. Lines and columns are left out where there is no text to point into. What a
/// terminal or JSON could not take (control characters, invalid UTF-8) is replaced.
std::string format(const Diagnostics&, const Sources&, DiagnosticStyle);

} // namespace yarte
