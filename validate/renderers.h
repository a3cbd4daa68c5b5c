// The renderers: a scene in, a linear picture and its times out. They are the programs that users run.
#pragma once

#include "validate/aov.h"
#include "validate/compare.h"
#include "validate/picture.h"
#include "validate/povray_cache.h"
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
    std::optional<PovrayCache> cache;
};

/// Files that the renderers leave in the workshop; reports keep them.
inline constexpr const char* yartePictureFile = "yarte.pfm";
inline constexpr const char* povrayPictureFile = "povray.ppm";
inline constexpr const char* povraySceneFile = "scene.pov";
inline constexpr const char* importedSceneFile = "imported.yarte";

/// True for a scene in POV-Ray's own language.
bool isPovrayScene(const std::filesystem::path& scene);

/// The scene (an absolute path) in YARTE's language: itself, or what yarte-convert made of it in the
/// workshop. Throws CaseError with what yarte-convert said.
std::filesystem::path importScene(Workshop&, const RenderSettings&, const std::filesystem::path& scene);

/// Renders `scene` (an absolute path) with YARTE: unclamped. Throws CaseError.
Picture renderWithYarte(Workshop&, const RenderSettings&, const std::filesystem::path& scene, YarteTimes&);

/// What YARTE knows of the pixels of its picture of `scene`. Throws CaseError.
Layers renderAov(Workshop&, const RenderSettings&, const std::filesystem::path& scene);

/// Writes `scene` for POV-Ray with its light times `exposure`, as povraySceneFile. Throws CaseError.
void convertForPovray(Workshop&, const RenderSettings&, const std::filesystem::path& scene, double exposure);

/// Renders with POV-Ray at the given size in pixels: values outside [0, 1] are clipped, steps are 1/65535. An
/// absolute path is a scene of the user's, whose folder may hold what it includes: it is never taken from the
/// cache. povraySceneFile is what convertForPovray wrote. Throws CaseError.
Picture renderWithPovray(Workshop&, const RenderSettings&, const std::filesystem::path& scene, int width,
                         int height, PovrayTimes&);

/// The seconds after `label` in the statistics that POV-Ray writes ("Parse Time", "Trace Time"), to a
/// millisecond.
std::optional<double> povraySeconds(std::string_view statistics, std::string_view label);

} // namespace yarte::validate
