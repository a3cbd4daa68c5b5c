// The renderers: a scene in, a linear picture and its times out. They are the programs that users run.
#pragma once

#include "validate/compare.h"
#include "validate/picture.h"
#include "validate/workshop.h"

#include <filesystem>
#include <optional>
#include <string>

namespace yarte::validate {

/// Where the programs are; an empty path: not found.
struct Programs {
    std::filesystem::path yarte, convert, povray;
};

struct RenderSettings {
    Programs programs;
    std::string size;             ///< "WxH"; empty: the scene's
    std::optional<int> processes; ///< for both renderers; none: one per core
};

/// Files that the renderers leave in the workshop; reports keep them.
inline constexpr const char* yartePictureFile = "yarte.pfm";
inline constexpr const char* povrayPictureFile = "povray.ppm";
inline constexpr const char* povraySceneFile = "scene.pov";

/// Renders `scene` (an absolute path) with YARTE: unclamped. Throws CaseError.
Picture renderWithYarte(Workshop&, const RenderSettings&, const std::filesystem::path& scene, YarteTimes&);

/// Writes `scene` for POV-Ray with its light times `exposure`, and renders that at the given size in pixels:
/// values outside [0, 1] are clipped, steps are 1/65535. Throws CaseError.
Picture renderWithPovray(Workshop&, const RenderSettings&, const std::filesystem::path& scene,
                         double exposure, int width, int height, PovrayTimes&);

/// The seconds after `label` in the statistics that POV-Ray writes ("Parse Time", "Trace Time"), to a
/// millisecond.
std::optional<double> povraySeconds(std::string_view statistics, std::string_view label);

} // namespace yarte::validate
