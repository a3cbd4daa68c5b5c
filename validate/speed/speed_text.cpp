#include "validate/speed/speed_text.h"

#include "validate/report_text.h"

#include <fmt/format.h>

namespace yarte::validate {

namespace {

std::string pointText(const SamplesPoint& point) {
    return fmt::format("{0}x{0} in {1}, rms {2:.2e}", point.samples, secondsText(point.trace),
                       point.error.rmse);
}

std::string curveLine(const SamplesCurve& curve) {
    std::string line = fmt::format("  {:<13} {}", curve.name, pointText(curve.points.front()));
    if (curve.points.size() > 1) line += fmt::format("; {}", pointText(curve.points.back()));
    return line + "\n";
}

std::string raysLine(const RayErrors& rays) {
    return fmt::format("  rays: {:<13} distance rms {:.1e}, normal rms {:.1e}; {} meet something else\n",
                       rays.name, rays.distance.rms, rays.normal.rms, rays.otherwise);
}

std::string triangleLine(const TessellationPoint& point) {
    return fmt::format("  {} triangles: {}, rms {:.2e}\n", point.triangles, secondsText(point.trace),
                       point.error.rmse);
}

} // namespace

std::string secondsText(const Seconds& seconds) { return secondsText(seconds.median); }

std::string speedCaseText(const SpeedCase& c) {
    std::string text = c.name;
    if (c.width > 0) text += fmt::format("  {}x{}", c.width, c.height);
    if (!c.message.empty()) return text + "  " + c.message + "\n";
    text += fmt::format(", against {0}x{0} samples\n", c.referenceSamples);
    if (!c.note.empty()) text += fmt::format("  {}\n", c.note);
    for (const RayErrors& rays : c.rays.programs) text += raysLine(rays);
    if (!c.rays.note.empty()) text += fmt::format("  {}\n", c.rays.note);
    for (const SamplesCurve& curve : c.curves)
        if (!curve.points.empty()) text += curveLine(curve);
    for (const TessellationPoint& point : c.tessellation.points) text += triangleLine(point);
    if (!c.tessellation.note.empty()) text += fmt::format("  {}\n", c.tessellation.note);
    return text;
}

} // namespace yarte::validate
