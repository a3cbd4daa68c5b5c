// Options: what the command line of `yarte-validate` asks for.
#pragma once

#include "validate/image_file.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace yarte::validate {

struct Options {
    std::vector<std::filesystem::path> scenes; ///< empty in `images` mode
    std::filesystem::path imageA, imageB;      ///< of `images` mode
    Encoding integers = Encoding::linear;      ///< of `images` mode
    std::filesystem::path output;              ///< the report's folder
    std::string size;                          ///< "WxH" or empty
    std::optional<int> processes;
    double timeLimit = 600;                       ///< seconds for each program
    std::filesystem::path yarte, convert, povray; ///< empty: to be searched
    bool jsonDiagnostics = false;
};

/// Either options, or the end: what to print (help, the version, or what is wrong) and the exit code.
struct ParsedOptions {
    std::optional<Options> options;
    std::string text;
    int exitCode = 0; ///< 0: `text` was asked for; 2: wrong usage
};

ParsedOptions parseOptions(int argc, const char* const* argv);

} // namespace yarte::validate
