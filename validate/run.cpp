#include "validate/run.h"

#include "validate/case.h"
#include "validate/case_names.h"
#include "validate/parallel.h"
#include "validate/text.h"
#include "yarte/version.h"

#include <algorithm>
#include <fmt/format.h>
#include <thread>

namespace yarte::validate {

namespace {

/// Of all pictures in the page: in base64 they are a third longer, and the page shall stay below 30 MB.
constexpr std::size_t pageLimit = 21'000'000;

int cores() { return std::max(1, static_cast<int>(std::thread::hardware_concurrency())); }

/// As many cases as cores, unless the user says: most scenes are too small to keep more cores busy.
int jobsFor(const Options& options) {
    const auto cases = static_cast<int>(options.scenes.size());
    return std::clamp(options.jobs.value_or(cores()), 1, std::max(1, cases));
}

CaseSettings settingsFor(const Options& options, const Programs& programs, int jobs) {
    CaseSettings settings;
    settings.timeLimit = options.timeLimit;
    settings.temporaryFolder = std::filesystem::temp_directory_path();
    settings.output = options.output;
    settings.pageLimit = pageLimit / std::max<std::size_t>(1, options.scenes.size());
    settings.tolerance = options.tolerance;
    settings.updateBaseline = options.updateBaseline;
    settings.render.programs = programs;
    settings.render.size = options.size;
    settings.render.processes = options.processes;
    // Cases that run side by side share the cores.
    if (jobs > 1 && !options.processes) settings.render.processes = std::max(1, cores() / jobs);
    if (!options.cache.empty()) settings.render.cache.emplace(options.cache);
    return settings;
}

Report compareImages(const Options& options, const CaseSettings& settings) {
    Report report;
    report.version = version;
    report.reference = "the second image";
    report.encoding = options.integers == Encoding::srgb
                          ? "Integer images were read as sRGB, floating-point ones as linear"
                          : "All images were read as linear, integers as fractions of their largest value";
    report.cases.push_back(validateImages(options.imageA, options.imageB, options.integers, settings));
    return report;
}

} // namespace

RunResult runCases(const Options& options, const Programs& programs, const StopSignal& stop,
                   const std::function<void(const CaseReport&)>& tell) {
    const int jobs = jobsFor(options);
    CaseSettings settings = settingsFor(options, programs, jobs);
    RunResult result;
    Report& report = result.report;
    if (options.scenes.empty()) {
        report = compareImages(options, settings);
        tell(report.cases[0]);
        return result;
    }
    std::optional<Baseline> baseline;
    if (!options.baseline.empty()) settings.baseline = &baseline.emplace(options.baseline);
    report.version = version;
    report.jobs = jobs;
    report.reference = baseline ? "the baseline " + cleanText(options.baseline.string()) : "POV-Ray";
    report.encoding = baseline
                          ? "All pictures are linear 32-bit floats"
                          : "YARTE's pictures are linear 32-bit floats, POV-Ray's linear 16-bit integers";
    const std::vector<std::string> names = caseNames(options.scenes);
    report.cases.resize(names.size());
    inParallel(
        names.size(), jobs,
        [&](std::size_t i) {
            stop.check();
            report.cases[i] = validateScene(names[i], options.scenes[i], settings, stop);
        },
        [&](std::size_t i) { tell(report.cases[i]); });
    stop.check();
    if (options.updateBaseline) {
        std::vector<Baseline::Scene> stored;
        for (std::size_t i = 0; i < names.size(); ++i)
            if (report.cases[i].baselineChange) stored.push_back({names[i], options.scenes[i]});
        result.removed = baseline->update(stored);
    }
    return result;
}

} // namespace yarte::validate
