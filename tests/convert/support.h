// A conversion in memory, for tests: text in, files out.
#pragma once

#include "convert/convert.h"
#include "yarte/base/file.h"

#include <filesystem>
#include <string>
#include <vector>

namespace yarte::convert::test {

/// What a run of convert() left.
struct Converted {
    Sources sources;
    Diagnostics diagnostics;
    Ledger ledger;
    std::vector<OutputFile> files;

    explicit Converted(const Options& options) { files = convert(options, sources, diagnostics, ledger); }
    std::string problems() const { return format(diagnostics, sources, DiagnosticStyle::plain); }
};

inline Options options(const std::filesystem::path& input, const std::filesystem::path& output) {
    Options result;
    result.input = input;
    result.output = output;
    result.from = formatOf(input);
    result.to = formatOf(output);
    return result;
}

inline const std::filesystem::path goldenFolder =
    std::filesystem::path(YARTE_SOURCE_DIR) / "tests/convert/golden";

/// The rows as "where|property|action", one a line.
inline std::string summary(const Ledger& ledger) {
    std::string text;
    for (const LedgerRow& row : ledger.rows())
        text += row.where + "|" + row.property + "|" + std::string(name(row.action)) + "\n";
    return text;
}

} // namespace yarte::convert::test
