#include "validate/speed/speed_plots.h"

#include "validate/speed/speed_text.h"

#include <fmt/format.h>

namespace yarte::validate {

namespace {

/// The time of a program's picture with the fewest samples.
double pictureTime(const SpeedCase& c, const std::string& program) {
    for (const SamplesCurve& curve : c.curves)
        if (curve.name == program && !curve.points.empty()) return curve.points[0].trace.median.value_or(0);
    return 0;
}

LogPlot rayPlot(const SpeedCase& c, const char* title, const char* yLabel, Spread RayErrors::*spread) {
    LogPlot plot{title, "time of the picture with one ray a pixel, seconds", yLabel, {}};
    for (const RayErrors& program : c.rays.programs) {
        const double time = pictureTime(c, program.name);
        const Spread& s = program.*spread;
        PlotCurve curve{program.name, {}};
        for (const auto& [label, error] : {std::pair{"max", s.max}, {"rms", s.rms}, {"median", s.median}})
            curve.points.push_back(
                {time, error, label, fmt::format("{}: {} {:.3g}", program.name, label, error)});
        plot.curves.push_back(std::move(curve));
    }
    return plot;
}

std::string pointTip(const std::string& name, const SamplesPoint& point, const PictureError& error) {
    return fmt::format("{}, {}×{} samples: {}, rms {:.3g}, max {:.3g}", name, point.samples, point.samples,
                       secondsText(point.trace), error.rmse, error.maxAbs);
}

LogPlot pixelPlot(const SpeedCase& c, const char* title, const char* yLabel, double PictureError::*value) {
    LogPlot plot{title, "trace time, seconds", yLabel, {}};
    PlotCurve fromDouble{"fast against double", {}};
    for (const SamplesCurve& curve : c.curves) {
        PlotCurve drawn{curve.name, {}};
        for (const SamplesPoint& point : curve.points) {
            const double time = point.trace.median.value_or(0);
            const std::string label = fmt::format("{}", point.samples);
            drawn.points.push_back(
                {time, point.error.*value, label, pointTip(curve.name, point, point.error)});
            if (point.fromDouble)
                fromDouble.points.push_back({time, (*point.fromDouble).*value, label,
                                             pointTip("fast against double", point, *point.fromDouble)});
        }
        plot.curves.push_back(std::move(drawn));
    }
    // In the place after three programs, also where one is missing: each has its colour.
    while (plot.curves.size() < 3) plot.curves.push_back({});
    if (!fromDouble.points.empty()) plot.curves.push_back(std::move(fromDouble));
    return plot;
}

std::string countText(std::size_t count) {
    if (count < 10'000) return fmt::format("{}", count);
    return count < 1'000'000 ? fmt::format("{}k", (count + 500) / 1000)
                             : fmt::format("{:.1f}M", static_cast<double>(count) / 1e6);
}

LogPlot triangleTimePlot(const Tessellation& t) {
    LogPlot plot{"Triangles for curved shapes: time and image error",
                 "building the tree and tracing, seconds",
                 "RMS error against the exact shapes",
                 {{"triangles", {}}}};
    for (const TessellationPoint& p : t.points)
        plot.curves[0].points.push_back(
            {p.build.median.value_or(0) + p.trace.median.value_or(0), p.error.rmse, countText(p.triangles),
             fmt::format("{} triangles: RMS error {:.3g}", p.triangles, p.error.rmse)});
    plot.marks.push_back({t.exactBuild.median.value_or(0) + t.exactTrace.median.value_or(0), "exact shapes"});
    return plot;
}

LogPlot triangleErrorPlot(const Tessellation& t) {
    LogPlot plot{"Triangles for curved shapes: their number and their error",
                 "triangles",
                 "error",
                 {{"RMS error of the picture", {}}, {"largest deviation, in radii", {}}}};
    for (const TessellationPoint& p : t.points) {
        const double deviation = t.radius > 0 ? p.deviation / t.radius : 0;
        const auto count = static_cast<double>(p.triangles);
        plot.curves[0].points.push_back(
            {count, p.error.rmse, "",
             fmt::format("{} triangles: RMS error {:.3g}", p.triangles, p.error.rmse)});
        plot.curves[1].points.push_back(
            {count, deviation, "",
             fmt::format("{} triangles: deviation {:.3g} radii", p.triangles, deviation)});
    }
    return plot;
}

} // namespace

std::vector<NamedPlot> plotsOf(const SpeedCase& c) {
    std::vector<NamedPlot> plots;
    const auto add = [&](const char* name, LogPlot plot) {
        if (!svg(plot).empty())
            plots.push_back({fmt::format("plots/{}-{}.svg", c.name, name), std::move(plot)});
    };
    add("rays-distance",
        rayPlot(c, "Rays: distance of the first hit", "relative error", &RayErrors::distance));
    add("rays-normal", rayPlot(c, "Rays: normal at the first hit", "error, radians", &RayErrors::normal));
    add("pixels-rms",
        pixelPlot(c, "Pixels: RMS error", "RMS error, linear light (1 = white)", &PictureError::rmse));
    add("pixels-max", pixelPlot(c, "Pixels: largest error", "largest error, linear light (1 = white)",
                                &PictureError::maxAbs));
    add("triangles-time", triangleTimePlot(c.tessellation));
    add("triangles-error", triangleErrorPlot(c.tessellation));
    return plots;
}

} // namespace yarte::validate
