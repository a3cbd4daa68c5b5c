// Names of cases: short, unique, and safe as names of folders.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace yarte::validate {

/// One for each scene, in their order: the file's stem; where several have the same, the folder's name before
/// it; where that is still the same, a number behind it. Only letters, digits, '_', '-' and '.' remain.
std::vector<std::string> caseNames(const std::vector<std::filesystem::path>& scenes);

/// `text` as a name of a folder.
std::string folderName(std::string text);

} // namespace yarte::validate
