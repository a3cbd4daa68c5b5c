#include "convert/povray/sdl/build_scene.h"

#include "convert/povray/sdl/build_body.h"
#include "convert/povray/sdl/build_camera.h"
#include "yarte/scene/check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace yarte::convert::povray::sdl {
namespace {

/// Of displays, and near to the curve that POV-Ray encodes its files by.
constexpr double displayGamma = 2.2;

/// POV-Ray 3.7 computes with linear light unless assumed_gamma says otherwise. Files before it that do not
/// say have numbers that are meant for the display as they are.
double gammaOf(const Model& model) {
    if (model.gamma) return *model.gamma;
    if (model.assumedGamma) return displayGamma / *model.assumedGamma;
    return model.languageVersion < 3.7 ? 1 : displayGamma;
}

class SceneBuilder {
public:
    SceneBuilder(const Model& model, const BuildOptions& options, Report& report, Diagnostics& diagnostics)
        : model_(model), options_(options), report_(report), diagnostics_(diagnostics) {}

    std::optional<Scene> build() {
        const CameraModel camera = model_.camera.value_or(CameraModel{});
        if (!model_.camera)
            report_.tell("camera",
                         {"everything", Action::added, "POV-Ray's default: at the origin, along z"});
        const bool isMirrored = isLeftHanded(camera);
        BuiltObjects objects = buildObjects(model_, isMirrored, {options_.chordError}, report_, diagnostics_);
        scene_.bodies = std::move(objects.bodies), scene_.materials = std::move(objects.materials);
        scene_.meshes = std::move(objects.meshes);
        for (const BuiltLight& light : objects.lights) {
            scene_.lights.push_back(placed(light, scene_, report_));
            errors(check(scene_.lights.back()));
        }
        settings();
        const double u = 1 / model_.unit;
        const Affine world{{u, 0, 0}, {0, u, 0}, {0, 0, isMirrored ? -u : u}, {}};
        if (const auto built = buildCamera(camera, world, scene_, report_, diagnostics_))
            scene_.camera = *built;
        for (std::size_t i = 0; i < scene_.materials.size(); ++i)
            errors(check(scene_.materials[i]), fmt::format("material {}: ", i + 1));
        summarise(isMirrored);
        return diagnostics_.hasErrors() ? std::nullopt : std::optional(std::move(scene_));
    }

private:
    void settings() {
        scene_.resolution = model_.resolution.value_or(options_.resolution);
        if (!model_.resolution)
            report_.tell("image", {"resolution", Action::added, "POV-Ray takes it from its command line"});
        scene_.gamma = gammaOf(model_);
        if (!model_.gamma)
            report_.tell("image", {"gamma", Action::added, fmt::format("{:.4g}", scene_.gamma)});
        const Colour b = model_.background;
        scene_.background = {std::max(b.r, 0.0), std::max(b.g, 0.0), std::max(b.b, 0.0)};
        if (scene_.background != b)
            report_.tell("background", {"colour", Action::approximated, "negative channels become 0"});
        const int levels = std::clamp(model_.maxTraceLevel, 1, maxRecursionLimit + 1); // as POV-Ray does
        if (levels != model_.maxTraceLevel)
            report_.tell("max_trace_level", {"max_trace_level", Action::approximated,
                                             fmt::format("{} becomes {}", model_.maxTraceLevel, levels)});
        scene_.maxRecursion = levels - 1;
        errors(check(scene_.resolution)), errors(checkGamma(scene_.gamma)),
            errors(checkBackground(scene_.background));
    }

    void errors(const Problems& problems, const std::string& what = {}) {
        for (const Problem& problem : problems) diagnostics_.error(problem.code, what + problem.message);
    }

    void summarise(bool isMirrored) {
        if (isMirrored)
            report_.tell("scene",
                         {"handedness", Action::exact, "z has changed its sign: the camera is left-handed"});
        report_.tell("lights",
                     {"everything", Action::exact,
                      scene_.lights.empty()
                          ? "there is none: only ambient light is seen, as in POV-Ray"
                          : fmt::format("{}, but for the rows that say otherwise", scene_.lights.size())});
        report_.tell("bodies",
                     {"everything", Action::exact,
                      fmt::format("{} bodies, but for the rows that say otherwise", scene_.bodies.size())});
    }

    const Model& model_;
    const BuildOptions& options_;
    Report& report_;
    Diagnostics& diagnostics_;
    Scene scene_;
};

} // namespace

std::optional<Scene> buildScene(const Model& model, const BuildOptions& options, const Sources& sources,
                                Diagnostics& diagnostics, Ledger& ledger) {
    Report report(sources);
    std::optional<Scene> scene = SceneBuilder(model, options, report, diagnostics).build();
    report.writeTo(ledger);
    return scene;
}

} // namespace yarte::convert::povray::sdl
