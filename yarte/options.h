// Options: what the command line of `yarte` asks for.
#pragma once

#include "yarte/base/image_file.h"
#include "yarte/engine/render.h"
#include "yarte/scene/scene.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace yarte {

enum class ProgressStyle { automatic, bar, json, none };

struct Options {
    std::filesystem::path scene;
    std::vector<std::filesystem::path> outputs; ///< at least one, each of a known format
    std::optional<Resolution> size;             ///< instead of the scene's
    std::optional<Tile> region;                 ///< of the image; may lie outside it
    Precision precision = Precision::inDouble;
    RenderMode mode = RenderMode::processes;
    int workers = 1;
    std::optional<int> tileSide; ///< nothing: whatever suits
    int samples = 1;             ///< rays along a pixel's side
    ImageEncoding encoding;      ///< all but the gamma, which is the scene's
    std::vector<std::filesystem::path> allowedFolders;
    ProgressStyle progress = ProgressStyle::automatic;
    std::optional<std::filesystem::path> stats;
    std::optional<std::filesystem::path> aov;  ///< .exr
    std::optional<std::filesystem::path> hits; ///< .csv
    std::optional<std::filesystem::path> checkpoint;
    bool resume = false;
    bool partial = false; ///< write what the checkpoint holds, and render nothing
    bool jsonDiagnostics = false;
};

/// Either options, or the end: what to print (help, the version, or what is wrong) and the exit code.
struct ParsedOptions {
    std::optional<Options> options;
    std::string text;
    int exitCode = 0; ///< 0: `text` was asked for; 2: wrong usage
};

ParsedOptions parseOptions(int argc, const char* const* argv);

} // namespace yarte
