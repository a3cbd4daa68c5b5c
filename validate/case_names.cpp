#include "validate/case_names.h"

#include <algorithm>
#include <map>
#include <set>

namespace yarte::validate {

namespace {

bool isSafe(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '-' || c == '.';
}

std::string stemOf(const std::filesystem::path& scene) { return folderName(scene.stem().string()); }

std::string nameWithFolder(const std::filesystem::path& scene) {
    const auto folder = std::filesystem::absolute(scene).lexically_normal().parent_path().filename();
    return folderName(folder.string() + "-" + scene.stem().string());
}

} // namespace

std::string folderName(std::string text) {
    std::replace_if(
        text.begin(), text.end(), [](char c) { return !isSafe(c); }, '_');
    return text.empty() || text.front() == '.' ? "_" + text : text;
}

std::vector<std::string> caseNames(const std::vector<std::filesystem::path>& scenes) {
    std::map<std::string, int> stems;
    for (const auto& scene : scenes) ++stems[stemOf(scene)];

    std::vector<std::string> names;
    std::set<std::string> taken;
    for (const auto& scene : scenes) {
        const std::string name = stems[stemOf(scene)] == 1 ? stemOf(scene) : nameWithFolder(scene);
        std::string unique = name;
        for (int number = 2; !taken.insert(unique).second; ++number)
            unique = name + "-" + std::to_string(number);
        names.push_back(unique);
    }
    return names;
}

} // namespace yarte::validate
