// The scenes of scenes/, for tests that render them all.
#pragma once

#include "yarte/lang/pmf.h"
#include "yarte/lang/scene_reader.h"

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

namespace yarte::test {

inline std::vector<std::string> sceneNames() {
    std::vector<std::string> names;
    for (const auto& entry :
         std::filesystem::directory_iterator(std::filesystem::path(YARTE_SOURCE_DIR) / "scenes"))
        if (entry.is_directory()) names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
}

inline Scene sceneNamed(const std::string& name) {
    constexpr MeshFormat formats[] = {{".pmf", readPmf}};
    Sources sources;
    Diagnostics diagnostics;
    return readScene(std::filesystem::path(YARTE_SOURCE_DIR) / "scenes" / name / (name + ".yarte"),
                     {{}, formats}, sources, diagnostics)
        .value();
}

} // namespace yarte::test
