#include "validate/case.h"

#include "validate/case_folder.h"
#include "validate/case_names.h"
#include "validate/judging.h"
#include "validate/removal.h"
#include "validate/text.h"
#include "validate/tolerance_json.h"
#include "yarte/base/file.h"

#include <algorithm>
#include <fmt/format.h>
#include <functional>

namespace yarte::validate {

namespace {

Aov aovOf(const Layers& layers) {
    try {
        return aovFrom(layers);
    } catch (const ImageError& error) {
        throw CaseError(cleanText(error.what()));
    }
}

/// What the parts of a case work on.
struct Case {
    CaseReport& report;
    const CaseSettings& settings;
    Side a, b;
    Tolerance tolerance;
    std::function<Layers()> renderLayers; ///< of a's scene; empty: there is none
    AovSource makeOlderAov;
    std::optional<FlipMap> flip;

    /// Throws CaseError if the pictures cannot be compared.
    void compareSides() {
        AovSource makeAov;
        if (renderLayers) makeAov = [this] { return aovOf(renderLayers()); };
        flip =
            judgeCase(report, {a.name, *a.picture}, {b.name, *b.picture}, tolerance, makeAov, makeOlderAov);
    }
    void setSize(const Picture& picture) {
        report.width = picture.width;
        report.height = picture.height;
    }
    void expose(double exposure) {
        report.exposure = exposure;
        a.picture = scaled(std::move(*a.picture), exposure);
    }
};

/// That of a file, if one is named, else the scene's. Throws CaseError with all that is wrong in it.
Tolerance sceneTolerance(const std::filesystem::path& scene, const std::filesystem::path& named) {
    try {
        return toleranceFor(scene, named);
    } catch (const ToleranceError& error) {
        throw CaseError(cleanText(error.what()));
    } catch (const FileError& error) {
        throw CaseError(cleanText(error.what()));
    }
}

/// As a file of integers would hold it.
Picture clipped(Picture picture) {
    for (Colour& c : picture.pixels)
        c = {std::clamp(c.r, 0.0, 1.0), std::clamp(c.g, 0.0, 1.0), std::clamp(c.b, 0.0, 1.0)};
    return picture;
}

/// The case's `b` by POV-Ray. A scene of its own cannot be darkened by a factor: it clips, and so do we.
void addPovray(Case& c, Workshop& workshop, const std::filesystem::path& original,
               const std::filesystem::path& scene) {
    const RenderSettings& render = c.settings.render;
    if (isPovrayScene(original)) {
        c.a.picture = clipped(std::move(*c.a.picture));
    } else {
        c.expose(exposureFor(maxValue(c.a.picture->view())));
        convertForPovray(workshop, render, scene, c.report.exposure);
    }
    c.b.picture = renderWithPovray(workshop, render, isPovrayScene(original) ? original : povraySceneFile,
                                   c.report.width, c.report.height, c.report.povray);
    c.compareSides();
}

/// What the baseline keeps of the scene besides its picture, if it can be made.
std::optional<Layers> bodiesOf(const Case& c) {
    try {
        return bodiesOnly(c.renderLayers());
    } catch (const CaseError&) {
        return std::nullopt;
    }
}

/// The case's `b` from the baseline, which gets the new picture if that is wanted.
void addBaseline(Case& c) {
    const Baseline& baseline = *c.settings.baseline;
    const bool update = c.settings.updateBaseline, isNew = !baseline.has(c.report.name);
    const Picture rendered = *c.a.picture;
    c.expose(exposureFor(maxValue(rendered.view())));
    BaselineChange change{BaselineChange::Kind::added, {}};
    if (!update || !isNew) {
        c.b.picture = scaled(baseline.read(c.report.name), c.report.exposure);
        if (const auto bodies = baseline.readBodies(c.report.name))
            c.makeOlderAov = [bodies] { return aovOf(*bodies); };
        change.kind = BaselineChange::Kind::changed;
        if (!update || haveOneSize(*c.a.picture, *c.b.picture)) {
            c.compareSides();
            change.maxAbs = c.report.comparison->maxAbs.value;
            if (change.maxAbs == 0) change.kind = BaselineChange::Kind::unchanged;
        }
    }
    if (!update) return;
    if (change.kind != BaselineChange::Kind::unchanged) baseline.store(c.report.name, rendered);
    baseline.storeBodies(c.report.name, bodiesOf(c)); // lines may have moved, though no pixel has changed
    c.report.baselineChange = change;
    c.report.verdict = Verdict::pass; // what is seen is now what is expected
    c.report.message.clear();
}

} // namespace

CaseReport validateScene(const std::string& name, const std::filesystem::path& scene,
                         const CaseSettings& settings, const StopSignal& stop) {
    CaseReport report;
    report.name = name;
    report.source = cleanText(scene.string());
    CaseFolder folder(report, settings.output);
    Workshop workshop(settings.temporaryFolder, settings.timeLimit, stop);
    Case c{report, settings, {"yarte's picture", "YARTE", "yarte.png", {}}, {}, {}, {}, {}, {}};
    if (settings.baseline != nullptr)
        c.b = {"the reference", "reference", "baseline.png", {}};
    else
        c.b = {"POV-Ray's picture", "POV-Ray", "povray.png", {}};
    const auto original = std::filesystem::absolute(scene);
    try {
        c.tolerance = sceneTolerance(original, settings.tolerance);
        const std::filesystem::path own = importScene(workshop, settings.render, original);
        c.renderLayers = [&, own] { return renderAov(workshop, settings.render, own); };
        c.a.picture = renderWithYarte(workshop, settings.render, own, report.yarte);
        c.setSize(*c.a.picture);
        checkFinite({c.a.name, *c.a.picture});
        if (settings.baseline != nullptr)
            addBaseline(c);
        else
            addPovray(c, workshop, original, own);
    } catch (const CaseError& error) {
        report.message = error.what();
    }
    report.commands = workshop.commands();
    for (const char* file : {yartePictureFile, povrayPictureFile, povraySceneFile, importedSceneFile})
        folder.keep(workshop, file);
    folder.addPictures(c.a, c.b, c.flip, c.tolerance.threshold, settings.pageLimit);
    return report;
}

CaseReport validateImages(const std::filesystem::path& a, const std::filesystem::path& b, Encoding integers,
                          const CaseSettings& settings) {
    CaseReport report;
    report.name = folderName(a.stem().string() + "-" + b.stem().string());
    report.source = cleanText(fmt::format("{} and {}", a.string(), b.string()));
    CaseFolder folder(report, settings.output);
    Case c{report,
           settings,
           {cleanText(a.string()), cleanText(a.filename().string()), "a.png", {}},
           {cleanText(b.string()), cleanText(b.filename().string()), "b.png", {}},
           {},
           {},
           {},
           {}};
    try {
        if (!settings.tolerance.empty()) c.tolerance = sceneTolerance(a, settings.tolerance);
        c.a.picture = readPicture(a, integers);
        c.b.picture = readPicture(b, integers);
        c.setSize(*c.a.picture);
        c.compareSides();
    } catch (const CaseError& error) {
        report.message = error.what();
    } catch (const ImageError& error) {
        report.message = cleanText(error.what());
    }
    folder.addPictures(c.a, c.b, c.flip, c.tolerance.threshold, settings.pageLimit);
    return report;
}

} // namespace yarte::validate
