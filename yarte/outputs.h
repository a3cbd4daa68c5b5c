// What can be said about the files to be written before any time is spent on rendering.
#pragma once

#include "yarte/options.h"

#include <filesystem>
#include <optional>
#include <string>

namespace yarte {

/// Throws FileError if it is plain already that `file` cannot be written: no such folder, no permission.
void requireWritable(const std::filesystem::path& file);

/// Why writing the outputs and statistics would destroy the scene; nothing if it would not.
std::optional<std::string> overwritesScene(const Options&);

/// Why there may be no new checkpoint of that name; nothing if there may, or if an old one is gone on with.
std::optional<std::string> checkpointInTheWay(const Options&);

/// Which output cannot hold an image of this size; nothing if all can.
std::optional<std::string> tooLargeForOutput(const Options&, int width, int height);

} // namespace yarte
