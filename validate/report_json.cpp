#include "validate/report_json.h"

#include <algorithm>
#include <cstdlib>
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

Json findingJson(const Finding& finding) {
    return {{"cause", name(finding.cause)},
            {"subject", finding.subject},
            {"body", finding.body ? Json(*finding.body) : Json()},
            {"light", finding.light ? Json(*finding.light) : Json()},
            {"line", finding.line > 0 ? Json(finding.line) : Json()},
            {"explanation", finding.explanation}};
}

Json regionJson(const Region& region) {
    Json json = {{"box", {region.box.x0, region.box.y0, region.box.x1, region.box.y1}},
                 {"pixels", region.pixels},
                 {"max_abs", region.maxError},
                 {"max_abs_at", pair(region.maxErrorAt)}};
    json.update(findingJson(region.finding));
    return json;
}

Json conditionJson(const ConditionResult& condition) {
    return {{"depth", condition.depth},   {"group", condition.isGroup},     {"text", condition.text},
            {"holds", condition.holds},   {"measured", condition.measured}, {"limit", condition.limit},
            {"reason", condition.reason}, {"pointer", condition.pointer}};
}

template <class Items, class ToJson>
Json list(const Items& items, const ToJson& toJson) {
    Json json = Json::array();
    for (const auto& item : items) json.push_back(toJson(item));
    return json;
}

Json caseJson(const CaseReport& report) {
    Json json;
    json["name"] = report.name;
    json["source"] = report.source;
    json["sides"] = {report.sides[0], report.sides[1]};
    json["verdict"] = name(report.verdict);
    json["message"] = report.message;
    json["width"] = report.width;
    json["height"] = report.height;
    json["exposure"] = report.exposure;
    addComparison(json, report.comparison);
    json["tolerance"] = report.tolerance;
    json["conditions"] = list(report.conditions, conditionJson);
    const auto& common = report.explanation.common;
    json["cause"] = common ? findingJson(*common) : Json();
    json["regions"] = list(report.explanation.regions, regionJson);
    json["yarte"] = {{"trace_s", orNull(report.yarte.trace)}, {"wall_s", orNull(report.yarte.wall)}};
    json["povray"] = {{"parse_s", orNull(report.povray.parse)},
                      {"trace_s", orNull(report.povray.trace)},
                      {"wall_s", orNull(report.povray.wall)},
                      {"cached", report.povray.cached}};
    json["commands"] = list(report.commands, commandJson);
    json["pictures"] = list(report.pictures, [&](const PictureRecord& picture) {
        return Json{{"label", picture.label}, {"file", folderOf(report) + "/" + picture.file}};
    });
    return json;
}

} // namespace

std::string jsonReport(const Report& report) {
    Json json;
    json["schema"] = 1;
    json["version"] = report.version;
    json["encoding"] = report.encoding;
    json["reference"] = report.reference;
    json["jobs"] = report.jobs;
    json["cases"] = list(report.cases, caseJson);
    return json.dump(2) + "\n";
}

std::optional<double> numberInJson(std::string_view text, std::string_view key) {
    const auto json = nlohmann::json::parse(text, nullptr, false);
    const auto found = json.is_object() ? json.find(std::string(key)) : json.end();
    if (found == json.end() || !found->is_number()) return std::nullopt;
    return found->get<double>();
}

std::optional<std::string> textInJson(std::string_view text, std::string_view key) {
    const auto json = nlohmann::json::parse(text, nullptr, false);
    const auto found = json.is_object() ? json.find(std::string(key)) : json.end();
    if (found == json.end() || !found->is_string()) return std::nullopt;
    return found->get<std::string>();
}

LedgerTotals tessellationInLedger(std::string_view text) {
    LedgerTotals totals;
    const auto json = nlohmann::json::parse(text, nullptr, false);
    if (!json.is_object()) return totals;
    for (const auto& row : json.value("rows", nlohmann::json::array())) {
        if (row.value("property", "") != "surface" || !row.at("bound").is_number()) continue;
        // "1234 triangles"
        const std::string detail = row.at("detail");
        totals.triangles += std::strtoull(detail.c_str(), nullptr, 10);
        totals.deviation = std::max(totals.deviation, row.at("bound").get<double>());
    }
    return totals;
}

} // namespace yarte::validate
