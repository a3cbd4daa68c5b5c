#include "validate/speed/measure_pixels.h"

#include "validate/compare.h"
#include "validate/metrics.h"
#include "validate/speed/box_filter.h"
#include "validate/speed/timing.h"

#include <algorithm>
#include <fmt/format.h>
#include <functional>
#include <map>

namespace yarte::validate {

namespace {

/// One picture: linear light, exposure 1.
struct Rendered {
    Picture picture;
    std::optional<double> trace, wall;
};

/// A curve in the making.
struct Program {
    std::string name;
    std::function<Rendered(int samples)> render;
    std::map<int, Picture> pictures{}; ///< of the first run; all runs give the same
    std::map<int, Timing> trace{}, wall{};

    void run(int samples) {
        Rendered rendered = render(samples);
        trace[samples].add(rendered.trace);
        wall[samples].add(rendered.wall);
        pictures.try_emplace(samples, std::move(rendered.picture));
    }
};

class Pixels {
public:
    Pixels(SpeedCase& result, Workshop& workshop, const SpeedSettings& settings,
           const std::filesystem::path& scene)
        : case_(result), workshop_(workshop), settings_(settings), scene_(scene) {}

    void measure() {
        const Picture reference = yarte(settings_.referenceSamples, false).picture;
        checkFinite({"the reference", reference});
        case_.width = reference.width, case_.height = reference.height;
        case_.referenceSamples = settings_.referenceSamples;
        std::vector<Program> programs;
        programs.push_back({"YARTE double", [this](int n) { return yarte(n, false); }});
        programs.push_back({"YARTE fast", [this](int n) { return yarte(n, true); }});
        if (settings_.withoutPovray.empty()) {
            prepareForPovray();
            programs.push_back({"POV-Ray", [this](int n) { return povray(n); }});
        } else {
            addNote(settings_.withoutPovray);
        }
        for (int run = 0; run < settings_.runs; ++run)
            for (const int samples : settings_.samples)
                for (Program& program : programs) program.run(samples);
        for (const Program& program : programs)
            case_.curves.push_back(
                curve(program, reference, &program == &programs[1] ? &programs[0] : nullptr));
    }

private:
    Rendered yarte(int samples, bool fast) {
        RenderSettings render = settings_.render;
        render.samples = samples;
        render.fast = fast;
        YarteTimes times;
        Picture picture = renderWithYarte(workshop_, render, scene_, times);
        if (fast && times.inDouble)
            addNote("YARTE fast computed in double: float is too coarse for this scene");
        return {std::move(picture), times.trace, times.wall};
    }

    /// Each once.
    void addNote(const std::string& note) {
        if (case_.note.find(note) == std::string::npos)
            case_.note += fmt::format("{}{}", case_.note.empty() ? "" : ". ", note);
    }

    /// The mean of N x N rays, as `yarte --samples N` takes it: the picture of N times the sides, filtered.
    Rendered povray(int samples) {
        PovrayTimes times;
        const Picture picture = renderWithPovray(workshop_, settings_.render, povraySceneFile,
                                                 case_.width * samples, case_.height * samples, times);
        return {scaled(boxFiltered(picture, samples), 1 / case_.exposure), times.trace, times.wall};
    }

    /// A file of 16 bits ends at 1, before any mean is taken: the brightest single ray decides the exposure.
    void prepareForPovray() {
        const int most = settings_.samples.back();
        RenderSettings render = settings_.render;
        render.size = fmt::format("{}x{}", case_.width * most, case_.height * most);
        YarteTimes ignored;
        const Picture rays = renderWithYarte(workshop_, render, scene_, ignored);
        checkFinite({"YARTE's picture", rays});
        case_.exposure = exposureFor(maxValue(rays.view()));
        convertForPovray(workshop_, settings_.render, scene_, case_.exposure);
    }

    SamplesCurve curve(const Program& program, const Picture& reference, const Program* inDouble) const {
        SamplesCurve result{program.name, {}};
        for (const auto& [samples, picture] : program.pictures) {
            checkFinite({fmt::format("{}'s picture", program.name), picture});
            SamplesPoint point;
            point.samples = samples;
            point.trace = program.trace.at(samples).seconds();
            point.wall = program.wall.at(samples).seconds();
            point.error = pictureError(picture, reference);
            if (inDouble != nullptr) point.fromDouble = pictureError(picture, inDouble->pictures.at(samples));
            result.points.push_back(point);
        }
        return result;
    }

    SpeedCase& case_;
    Workshop& workshop_;
    const SpeedSettings& settings_;
    const std::filesystem::path& scene_;
};

} // namespace

PictureError pictureError(const Picture& picture, const Picture& reference) {
    if (!haveOneSize(picture, reference))
        throw CaseError(fmt::format("two pictures of one scene have different sizes: {}x{} and {}x{}",
                                    picture.width, picture.height, reference.width, reference.height));
    return {rmse(picture.view(), reference.view()), maxAbs(picture.view(), reference.view()).value};
}

void measurePixels(SpeedCase& result, Workshop& workshop, const SpeedSettings& settings,
                   const std::filesystem::path& scene) {
    Pixels(result, workshop, settings, scene).measure();
}

} // namespace yarte::validate
