// Options: what the command line of `yarte-convert` asks for.
#pragma once

#include "convert/format.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace yarte::convert {

struct Options {
    std::filesystem::path input, output; ///< empty: standard input, standard output
    const Format* from = nullptr;        ///< can be read
    const Format* to = nullptr;          ///< can be written
    WriteOptions writing;
    std::vector<std::filesystem::path> allowedFolders;
    std::optional<std::filesystem::path> writableFolder; ///< for the files that a .pov program writes
    std::optional<std::filesystem::path> report;
    bool strict = false;
    bool jsonDiagnostics = false;
};

/// Either options, or the end: what to print (help, the version, the formats, or what is wrong) and the exit
/// code.
struct ParsedOptions {
    std::optional<Options> options;
    std::string text;
    int exitCode = 0; ///< 0: `text` was asked for; 2: wrong usage
};

ParsedOptions parseOptions(int argc, const char* const* argv);

} // namespace yarte::convert
