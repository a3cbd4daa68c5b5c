// Options: what the command line of `yarte-validate` asks for.
#pragma once

#include "validate/image_file.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace yarte::validate {

/// Of `speed`.
struct SpeedOptions {
    std::vector<int> samples{1, 2, 3, 4, 6, 8}; ///< N, ascending, below the reference's
    int referenceSamples = 16;
    int runs = 3;
    int rays = 4096;                                                        ///< 0: none
    std::vector<double> chordErrors{0.1, 0.03, 0.01, 0.003, 0.001, 0.0003}; ///< descending; empty: none
    bool noPovray = false;
};

struct Options {
    std::vector<std::filesystem::path> scenes; ///< empty in `images` mode
    std::filesystem::path imageA, imageB;      ///< of `images` mode
    Encoding integers = Encoding::linear;      ///< of `images` mode
    std::optional<SpeedOptions> speed;         ///< `speed` was asked for
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
