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
    std::optional<int> jobs;         ///< cases side by side
    std::filesystem::path tolerance; ///< of all cases; empty: each scene's own
    std::filesystem::path cache;     ///< of POV-Ray's pictures; empty: none
    std::filesystem::path baseline;  ///< compare with this one; empty: with POV-Ray
    bool updateBaseline = false;
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
