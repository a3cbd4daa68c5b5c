#include "validate/speed/speed_run.h"

#include "validate/case_names.h"
#include "validate/compare.h"
#include "validate/speed/measure_pixels.h"
#include "validate/speed/measure_rays.h"
#include "validate/speed/measure_tessellation.h"
#include "validate/speed/speed_settings.h"
#include "validate/text.h"
#include "yarte/lang/pmf.h"
#include "yarte/lang/scene_reader.h"
#include "yarte/version.h"

#include <fmt/format.h>

namespace yarte::validate {

namespace {

SpeedSettings settingsFor(const Options& options, const Programs& programs) {
    const SpeedOptions& speed = *options.speed;
    SpeedSettings settings;
    settings.timeLimit = options.timeLimit;
    settings.temporaryFolder = std::filesystem::temp_directory_path();
    settings.samples = speed.samples;
    settings.referenceSamples = speed.referenceSamples;
    settings.runs = speed.runs;
    settings.rays = speed.rays;
    settings.chordErrors = speed.chordErrors;
    settings.render.programs = programs;
    settings.render.size = options.size;
    settings.render.processes = options.processes.value_or(1);
    if (speed.noPovray)
        settings.withoutPovray = "POV-Ray is left out (--no-povray)";
    else if (programs.povray.empty())
        settings.withoutPovray =
            "POV-Ray is left out: povray not found; install it, or give its place with --povray";
    return settings;
}

/// Canonical: its meshes lie beside it, as .pmf.
Scene readCanonical(const std::filesystem::path& file) {
    constexpr MeshFormat formats[] = {{".pmf", readPmf}};
    Sources sources;
    Diagnostics diagnostics;
    auto scene = readScene(file, {{}, formats}, sources, diagnostics);
    if (!scene) throw CaseError(cleanText(format(diagnostics, sources, DiagnosticStyle::plain)));
    return std::move(*scene);
}

SpeedCase measure(const std::string& name, const std::filesystem::path& scene, const SpeedSettings& settings,
                  const StopSignal& stop) {
    SpeedCase result;
    result.name = name;
    result.source = cleanText(scene.string());
    Workshop workshop(settings.temporaryFolder, settings.timeLimit, stop);
    try {
        const auto own = importScene(workshop, settings.render, std::filesystem::absolute(scene));
        measurePixels(result, workshop, settings, own);
        canonicalScene(workshop, settings.render, own);
        const Scene content = readCanonical(workshop.file(canonicalSceneFile));
        if (settings.rays > 0)
            result.rays = measureRays(workshop, settings, own, content, result.width, result.height);
        else
            result.rays.note = "Left out (--rays 0)";
        if (!settings.chordErrors.empty())
            result.tessellation = measureTessellation(workshop, settings, own, content);
        else
            result.tessellation.note = "Left out (--no-tessellation)";
    } catch (const CaseError& error) {
        result.message = error.what();
    }
    result.commands = workshop.commands();
    return result;
}

} // namespace

SpeedReport runSpeed(const Options& options, const Programs& programs, const StopSignal& stop,
                     const std::function<void(const SpeedCase&)>& tell) {
    const SpeedSettings settings = settingsFor(options, programs);
    SpeedReport report;
    report.version = version;
    report.runs = settings.runs;
    report.processes = settings.render.processes.value();
    const std::vector<std::string> names = caseNames(options.scenes);
    for (std::size_t i = 0; i < names.size(); ++i) {
        report.cases.push_back(measure(names[i], options.scenes[i], settings, stop));
        tell(report.cases.back());
    }
    stop.check();
    return report;
}

} // namespace yarte::validate
