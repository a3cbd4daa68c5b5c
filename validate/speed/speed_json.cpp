#include "validate/speed/speed_json.h"

#include "validate/speed/speed_plots.h"

#include <nlohmann/json.hpp>

namespace yarte::validate {

namespace {

using Json = nlohmann::ordered_json; // keys stay in the order written here

Json orNull(const std::optional<double>& value) { return value ? Json(*value) : Json(); }

Json secondsJson(const Seconds& s) {
    return {{"median", orNull(s.median)}, {"min", orNull(s.least)}, {"max", orNull(s.most)}};
}

Json errorJson(const PictureError& error) { return {{"rmse", error.rmse}, {"max_abs", error.maxAbs}}; }

Json spreadJson(const Spread& s) { return {{"median", s.median}, {"rms", s.rms}, {"max", s.max}}; }

template <class Items, class ToJson>
Json list(const Items& items, const ToJson& toJson) {
    Json json = Json::array();
    for (const auto& item : items) json.push_back(toJson(item));
    return json;
}

Json pointJson(const SamplesPoint& point) {
    return {{"samples", point.samples},
            {"trace_s", secondsJson(point.trace)},
            {"wall_s", secondsJson(point.wall)},
            {"error", errorJson(point.error)},
            {"from_double", point.fromDouble ? errorJson(*point.fromDouble) : Json()}};
}

Json curveJson(const SamplesCurve& curve) {
    return {{"name", curve.name}, {"points", list(curve.points, pointJson)}};
}

Json trianglesJson(const TessellationPoint& point) {
    return {{"chord_error", point.chordError},     {"deviation", point.deviation},
            {"triangles", point.triangles},        {"convert_s", secondsJson(point.convert)},
            {"build_s", secondsJson(point.build)}, {"trace_s", secondsJson(point.trace)},
            {"wall_s", secondsJson(point.wall)},   {"error", errorJson(point.error)}};
}

Json tessellationJson(const Tessellation& t) {
    return {{"note", t.note},
            {"largest_radius", t.radius},
            {"exact",
             {{"build_s", secondsJson(t.exactBuild)},
              {"trace_s", secondsJson(t.exactTrace)},
              {"wall_s", secondsJson(t.exactWall)}}},
            {"points", list(t.points, trianglesJson)}};
}

Json raysJson(const Rays& rays) {
    return {{"note", rays.note},
            {"width", rays.width},
            {"height", rays.height},
            {"met", rays.met},
            {"programs", list(rays.programs, [](const RayErrors& program) {
                 return Json{{"name", program.name},
                             {"compared", program.compared},
                             {"otherwise", program.otherwise},
                             {"distance", spreadJson(program.distance)},
                             {"normal", spreadJson(program.normal)}};
             })}};
}

Json caseJson(const SpeedCase& c) {
    return {
        {"name", c.name},
        {"source", c.source},
        {"message", c.message},
        {"note", c.note},
        {"width", c.width},
        {"height", c.height},
        {"reference_samples", c.referenceSamples},
        {"exposure", c.exposure},
        {"rays", raysJson(c.rays)},
        {"curves", list(c.curves, curveJson)},
        {"tessellation", tessellationJson(c.tessellation)},
        {"plots", list(plotsOf(c),
                       [](const NamedPlot& plot) {
                           return Json{{"title", plot.plot.title}, {"file", plot.file}};
                       })},
        {"commands", list(c.commands, [](const CommandRecord& command) {
             return Json{{"line", command.line}, {"outcome", command.outcome}, {"wall_s", command.seconds}};
         })}};
}

} // namespace

std::string speedJson(const SpeedReport& report) {
    Json json;
    json["schema"] = 1;
    json["version"] = report.version;
    json["units"] = {{"*_s", "seconds"},
                     {"error, from_double", "linear light, 1 = white"},
                     {"distance", "parts of the true distance"},
                     {"normal", "radians"},
                     {"chord_error, deviation, largest_radius", "scene units"}};
    json["runs"] = report.runs;
    json["processes"] = report.processes;
    json["cases"] = list(report.cases, caseJson);
    return json.dump(2) + "\n";
}

} // namespace yarte::validate
