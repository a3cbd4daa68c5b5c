#include "validate/report_json.h"

#include <nlohmann/json.hpp>

namespace yarte::validate {

namespace {

using Json = nlohmann::ordered_json; // keys stay in the order written here

Json orNull(const std::optional<double>& value) { return value ? Json(*value) : Json(); }

Json pair(Pixel pixel) { return Json::array({pixel.x, pixel.y}); }

void addComparison(Json& json, const std::optional<Comparison>& comparison) {
    if (!comparison) {
        for (const char* key :
             {"max_abs", "max_abs_at", "rmse", "psnr", "flip_mean", "flip_max", "flip_max_at", "pixels_over"})
            json[key] = nullptr;
        return;
    }
    json["max_abs"] = comparison->maxAbs.value;
    json["max_abs_at"] = pair(comparison->maxAbs.at);
    json["rmse"] = comparison->rmse;
    json["psnr"] = orNull(comparison->psnr);
    json["flip_mean"] = comparison->flip.mean;
    json["flip_max"] = comparison->flip.max;
    json["flip_max_at"] = pair(comparison->flip.maxAt);
    json["pixels_over"] = {{"threshold", comparison->threshold}, {"count", comparison->pixelsOver}};
}

Json commandJson(const CommandRecord& command) {
    return {{"line", command.line}, {"outcome", command.outcome}, {"wall_s", command.seconds}};
}

Json caseJson(const CaseReport& report) {
    Json json;
    json["name"] = report.name;
    json["source"] = report.source;
    json["verdict"] = name(report.verdict);
    json["message"] = report.message;
    json["width"] = report.width;
    json["height"] = report.height;
    json["exposure"] = report.exposure;
    addComparison(json, report.comparison);
    json["regions"] = Json::array();
    json["yarte"] = {{"trace_s", orNull(report.yarte.trace)}, {"wall_s", orNull(report.yarte.wall)}};
    json["povray"] = {{"parse_s", orNull(report.povray.parse)},
                      {"trace_s", orNull(report.povray.trace)},
                      {"wall_s", orNull(report.povray.wall)}};
    json["commands"] = Json::array();
    for (const CommandRecord& command : report.commands) json["commands"].push_back(commandJson(command));
    json["pictures"] = Json::array();
    for (const PictureRecord& picture : report.pictures)
        json["pictures"].push_back(
            {{"label", picture.label}, {"file", folderOf(report) + "/" + picture.file}});
    return json;
}

} // namespace

std::string jsonReport(const Report& report) {
    Json json;
    json["schema"] = 1;
    json["version"] = report.version;
    json["encoding"] = report.encoding;
    json["cases"] = Json::array();
    for (const CaseReport& c : report.cases) json["cases"].push_back(caseJson(c));
    return json.dump(2) + "\n";
}

std::optional<double> numberInJson(std::string_view text, std::string_view key) {
    const auto json = nlohmann::json::parse(text, nullptr, false);
    if (!json.is_object()) return std::nullopt;
    const auto found = json.find(std::string(key));
    if (found == json.end() || !found->is_number()) return std::nullopt;
    return found->get<double>();
}

} // namespace yarte::validate
