// What round trips through other formats are compared by, and the scenes that they start from.
#pragma once

#include "yarte/lang/pmf.h"
#include "yarte/lang/scene_printer.h"
#include "yarte/lang/scene_reader.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace yarte::convert::test {

/// The text, and that of every mesh.
inline std::string everything(const Scene& scene) {
    std::string text = printScene(scene);
    for (const MeshData& mesh : scene.meshes) text += "\n" + mesh.path + "\n" + printPmf(mesh);
    return text;
}

/// Calls `use` with every scene of scenes/ and its name.
template <typename Use>
void forEachSceneOfOurs(const Use& use) {
    namespace fs = std::filesystem;
    int count = 0;
    for (const auto& folder : fs::directory_iterator(fs::path(YARTE_SOURCE_DIR) / "scenes")) {
        if (!folder.is_directory()) continue;
        const std::string name = folder.path().filename();
        Sources sources;
        Diagnostics diagnostics;
        constexpr MeshFormat pmf{".pmf", readPmf};
        const auto scene =
            readScene(folder.path() / (name + ".yarte"), {{}, {&pmf, 1}}, sources, diagnostics);
        ASSERT_TRUE(scene) << name;
        use(*scene, name);
        ++count;
    }
    EXPECT_GE(count, 13);
}

} // namespace yarte::convert::test
