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
    // Of YARTE:
    int samples = 1;   ///< N x N rays a pixel
    bool fast = false; ///< --precision fast
};

/// Files that the renderers leave in the workshop; reports keep them.
inline constexpr const char* yartePictureFile = "yarte.pfm";
inline constexpr const char* povrayPictureFile = "povray.ppm";
inline constexpr const char* povraySceneFile = "scene.pov";
inline constexpr const char* importedSceneFile = "imported.yarte";
inline constexpr const char* canonicalSceneFile = "canonical.yarte";
inline constexpr const char* tessellatedSceneFile = "tessellated.yarte";
/// What a scene for runPovrayProgram writes.
inline constexpr const char* rayAnswersFile = "answers.csv";

/// True for a scene in POV-Ray's own language.
bool isPovrayScene(const std::filesystem::path& scene);

/// The scene (an absolute path) in YARTE's language: itself, or what yarte-convert made of it in the
/// workshop. Throws CaseError with what yarte-convert said.
std::filesystem::path importScene(Workshop&, const RenderSettings&, const std::filesystem::path& scene);

/// Renders `scene` (an absolute path) with YARTE: unclamped. Throws CaseError.
Picture renderWithYarte(Workshop&, const RenderSettings&, const std::filesystem::path& scene, YarteTimes&);

/// What YARTE knows of the pixels of its picture of `scene`. Throws CaseError.
Layers renderAov(Workshop&, const RenderSettings&, const std::filesystem::path& scene);

/// What the camera rays of its picture of `scene` meet: the text of `yarte --hits`. Throws CaseError.
std::string renderHits(Workshop&, const RenderSettings&, const std::filesystem::path& scene);

/// Writes `scene` with its meshes into the workshop, as canonicalSceneFile: nothing else need be read to know
/// all of it. Throws CaseError.
void canonicalScene(Workshop&, const RenderSettings&, const std::filesystem::path& scene);

struct Conversion {
    double seconds = 0;        ///< wall clock
    std::size_t triangles = 0; ///< of all curved shapes, each counted where it stands
    double deviation = 0;      ///< the largest, in scene units
};

/// Writes `scene` with triangles for its curved shapes, no farther than `chordError` (scene units) from them,
/// as tessellatedSceneFile. Throws CaseError.
Conversion tessellateScene(Workshop&, const RenderSettings&, const std::filesystem::path& scene,
                           double chordError);

/// Writes `scene` for POV-Ray with its light times `exposure`, as povraySceneFile. Throws CaseError.
void convertForPovray(Workshop&, const RenderSettings&, const std::filesystem::path& scene, double exposure);

/// Renders with POV-Ray at the given size in pixels: values outside [0, 1] are clipped, steps are 1/65535. An
/// absolute path is a scene of the user's, whose folder may hold what it includes: it is never taken from the
/// cache. povraySceneFile is what convertForPovray wrote. Throws CaseError.
Picture renderWithPovray(Workshop&, const RenderSettings&, const std::filesystem::path& scene, int width,
                         int height, PovrayTimes&);

/// Runs a scene in POV-Ray's language for what it writes to rayAnswersFile, not for its picture. Throws
/// CaseError.
std::string runPovrayProgram(Workshop&, const RenderSettings&, const std::string& sdl);

/// The seconds after `label` in the statistics that POV-Ray writes ("Parse Time", "Trace Time"), to a
/// millisecond.
std::optional<double> povraySeconds(std::string_view statistics, std::string_view label);

} // namespace yarte::validate
