#include "validate/speed/measure_tessellation.h"

#include "validate/compare.h"
#include "validate/speed/measure_pixels.h"
#include "validate/speed/timing.h"
#include "yarte/base/number.h"

#include <algorithm>
#include <fmt/format.h>
#include <variant>

namespace yarte::validate {

namespace {

/// More triangles are not tried: their file alone has a hundred megabytes.
constexpr std::size_t mostTriangles = 1'000'000;

/// What is measured of one chord error, or of the exact shapes.
struct Step {
    Conversion conversion{};
    std::optional<Picture> picture{};
    Timing convert{}, build{}, trace{}, wall{};
};

double radiusOf(const Shape& shape) {
    return std::visit(
        []<class S>(const S& s) -> double {
            if constexpr (std::is_same_v<S, Frustum>)
                return std::max(s.baseRadius, s.topRadius);
            else if constexpr (requires { s.radius; })
                return s.radius;
            else
                return 0;
        },
        shape);
}

} // namespace

double largestRadius(const Scene& scene) {
    double largest = 0;
    for (const Body& body : scene.bodies) largest = std::max(largest, radiusOf(body.shape));
    return largest;
}

Tessellation measureTessellation(Workshop& workshop, const SpeedSettings& settings,
                                 const std::filesystem::path& scene, const Scene& content) {
    Tessellation result;
    result.radius = largestRadius(content);
    if (result.radius == 0) {
        result.note = "The scene has no curved shapes";
        return result;
    }
    const auto render = [&](const std::filesystem::path& file, Step& step) {
        YarteTimes times;
        Picture picture = renderWithYarte(workshop, settings.render, file, times);
        step.build.add(times.build), step.trace.add(times.trace), step.wall.add(times.wall);
        return picture;
    };
    std::vector<double> chordErrors;
    for (const double part : settings.chordErrors) chordErrors.push_back(part * result.radius);
    std::vector<Step> steps(chordErrors.size());
    Step exact;
    for (int run = 0; run < settings.runs; ++run) {
        exact.picture = render(scene, exact);
        for (std::size_t i = 0; i < steps.size(); ++i) {
            Step& step = steps[i];
            step.conversion = tessellateScene(workshop, settings.render, scene, chordErrors[i]);
            step.convert.add(step.conversion.seconds);
            if (step.conversion.triangles > mostTriangles) {
                result.note = fmt::format("{} triangles and more were left out", step.conversion.triangles);
                steps.resize(i);
                break;
            }
            step.picture = render(tessellatedSceneFile, step);
        }
    }
    result.exactBuild = exact.build.seconds(), result.exactTrace = exact.trace.seconds();
    result.exactWall = exact.wall.seconds();
    for (std::size_t i = 0; i < steps.size(); ++i) {
        const Step& step = steps[i];
        checkFinite({"the picture of triangles", *step.picture});
        result.points.push_back({chordErrors[i], step.conversion.deviation, step.conversion.triangles,
                                 step.convert.seconds(), step.build.seconds(), step.trace.seconds(),
                                 step.wall.seconds(), pictureError(*step.picture, *exact.picture)});
    }
    return result;
}

} // namespace yarte::validate
