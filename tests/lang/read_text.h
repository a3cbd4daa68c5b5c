// Reading scenes and meshes that tests write as text.
#pragma once

#include "yarte/lang/pmf.h"
#include "yarte/lang/scene_reader.h"

#include <string>

namespace yarte::test {

inline constexpr MeshFormat pmfOnly[] = {{".pmf", readPmf}};

/// A scene's text, read; `folder` is where its meshes lie.
struct SceneText {
    explicit SceneText(std::string text, const std::filesystem::path& folder = {},
                       const SceneReading& reading = {{}, pmfOnly}) {
        scene =
            parseScene(sources.add("scene.yarte", std::move(text)), folder, reading, sources, diagnostics);
    }
    std::string messages() const { return format(diagnostics, sources, DiagnosticStyle::plain); }

    Sources sources;
    Diagnostics diagnostics;
    std::optional<Scene> scene;
};

struct PmfText {
    explicit PmfText(std::string text) {
        mesh = parsePmf(sources.add("mesh.pmf", std::move(text)), sources, diagnostics);
    }
    std::string messages() const { return format(diagnostics, sources, DiagnosticStyle::plain); }

    Sources sources;
    Diagnostics diagnostics;
    std::optional<MeshData> mesh;
};

/// A complete scene but for its objects.
inline const std::string header = "camera_position 0 0 10\nfocus_point 0 0 0\nlight_source 0 9 9 1\n"
                                  "material 0 0 0 1 1 1 0 0 0 1 0 0 0\n";

} // namespace yarte::test
