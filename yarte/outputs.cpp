#include "yarte/outputs.h"

#include "yarte/base/file.h"

#include <fmt/format.h>

#include <system_error>

#include <unistd.h>

namespace yarte {

namespace fs = std::filesystem;

void requireWritable(const fs::path& file) {
    std::error_code error;
    const fs::file_status status = fs::status(file, error);
    if (fs::is_directory(status)) throw FileError(file, "is a directory");
    if (fs::exists(status) && access(file.c_str(), W_OK) != 0) throw FileError(file, "permission denied");
    if (fs::exists(status) && !fs::is_regular_file(status))
        return; // a device or pipe: nothing is made beside it
    const fs::path folder = file.has_parent_path() ? file.parent_path() : ".";
    if (!fs::is_directory(folder, error)) throw FileError(file, "no such folder");
    if (access(folder.c_str(), W_OK | X_OK) != 0) throw FileError(file, "its folder is not writable");
}

std::optional<std::string> overwritesScene(const Options& options) {
    const auto isScene = [&](const fs::path& file) {
        std::error_code error; // neither need exist
        return fs::equivalent(file, options.scene, error);
    };
    for (const fs::path& output : options.outputs)
        if (isScene(output)) return fmt::format("{}: the output is the scene itself", output.string());
    if (options.stats && isScene(*options.stats))
        return fmt::format("{}: the statistics would overwrite the scene", options.stats->string());
    if (options.aov && isScene(*options.aov))
        return fmt::format("{}: the AOV would overwrite the scene", options.aov->string());
    if (options.hits && isScene(*options.hits))
        return fmt::format("{}: the hits would overwrite the scene", options.hits->string());
    return std::nullopt;
}

std::optional<std::string> checkpointInTheWay(const Options& options) {
    std::error_code error;
    if (!options.checkpoint || options.resume || options.partial || !fs::exists(*options.checkpoint, error))
        return std::nullopt;
    return fmt::format("{}: there is a checkpoint already; --resume goes on from it",
                       options.checkpoint->string());
}

std::optional<std::string> tooLargeForOutput(const Options& options, int width, int height) {
    for (const fs::path& output : options.outputs)
        if (!canHold(*imageFormat(output), width, height))
            return fmt::format("{}: this format cannot hold {}x{} pixels", output.string(), width, height);
    return std::nullopt;
}

} // namespace yarte
