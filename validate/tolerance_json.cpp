#include "validate/tolerance_json.h"

#include "yarte/base/file.h"
#include "yarte/base/number.h"
#include "yarte/base/source.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

namespace yarte::validate {

namespace {

using Json = nlohmann::json;

/// Of groups in each other: what reads and judges them recurses, and each carries its place in the file.
constexpr int maxGroupDepth = 50;

/// The kinds by their keys, pixels_over apart: its object decides between a count and a fraction.
constexpr std::pair<const char*, Condition::Kind> kinds[] = {{"all", Condition::Kind::all},
                                                             {"any", Condition::Kind::any},
                                                             {"max_abs", Condition::Kind::maxAbs},
                                                             {"rmse", Condition::Kind::rmse},
                                                             {"flip_mean", Condition::Kind::flipMean},
                                                             {"pixels_over", Condition::Kind::pixelCount}};

class Parser {
public:
    explicit Parser(std::filesystem::path folder) : folder_(std::move(folder)) {}

    Condition condition(const Json&, const std::string& place, bool isRoot = false);
    std::vector<ToleranceProblem> problems;

private:
    void problem(const std::string& place, std::string_view code, std::string message) {
        problems.push_back({place, code, std::move(message)});
    }
    void body(Condition&, const char* key, const Json&, const std::string& place);
    void group(Condition&, const Json&, const std::string& place);
    void pixelsOver(Condition&, const Json&, const std::string& place);
    double limit(const Json&, const std::string& place);
    PixelSet pixelSet(const Json&, const std::string& place);
    void rectangle(PixelSet&, const Json&, const std::string& place);
    void image(PixelSet&, const Json&, const std::string& place);
    void unknownKeys(const Json&, const std::string& place, std::initializer_list<std::string_view> known);
    template <class Read>
    void each(const Json&, const std::string& place, Read read);

    std::filesystem::path folder_;
    int groupDepth_ = 0;
};

void Parser::unknownKeys(const Json& json, const std::string& place,
                         std::initializer_list<std::string_view> known) {
    for (const auto& [key, value] : json.items())
        if (std::find(known.begin(), known.end(), key) == known.end())
            problem(place + "/" + key, "tolerance.unknown-key", fmt::format("'{}' means nothing here", key));
}

template <class Read>
void Parser::each(const Json& json, const std::string& place, Read read) {
    if (!json.is_array() || json.empty()) {
        problem(place, "tolerance.not-a-list", "must be a list with something in it");
        return;
    }
    for (std::size_t i = 0; i < json.size(); ++i) read(json[i], fmt::format("{}/{}", place, i));
}

/// A number, or a fraction as text: "4/65535" is more honest than its decimals.
double Parser::limit(const Json& json, const std::string& place) {
    std::optional<double> value;
    if (json.is_number()) value = json.get<double>();
    if (json.is_string()) {
        const auto text = json.get<std::string>();
        const std::size_t slash = text.find('/');
        const ParsedNumber above = parseNumber(text.substr(0, slash));
        const ParsedNumber below = parseNumber(slash == std::string::npos ? "1" : text.substr(slash + 1));
        if (!above.error && !below.error && below.value > 0) value = above.value / below.value;
    }
    if (!value || !std::isfinite(*value)) {
        problem(place, "tolerance.limit-not-number", "must be a number, or a fraction like \"4/65535\"");
        return 0;
    }
    if (*value < 0)
        problem(place, "tolerance.limit-negative", fmt::format("must not be negative, got {}", *value));
    return *value;
}

void Parser::rectangle(PixelSet& set, const Json& json, const std::string& place) {
    const auto isCoordinate = [](const Json& v) {
        return v.is_number_integer() && v.get<std::int64_t>() >= 0 && v.get<std::int64_t>() <= 1 << 24;
    };
    if (!json.is_array() || json.size() != 4 || !std::all_of(json.begin(), json.end(), isCoordinate) ||
        json[0] >= json[2] || json[1] >= json[3])
        return problem(place, "tolerance.rectangle-invalid",
                       "must be [x0, y0, x1, y1], whole numbers with x0 < x1 and y0 < y1");
    set.rectangles.push_back({json[0], json[1], json[2], json[3]});
}

void Parser::image(PixelSet& set, const Json& json, const std::string& place) {
    if (!json.is_string())
        return problem(place, "tolerance.image-invalid", "must be the name of an image file");
    const std::filesystem::path file = folder_ / json.get<std::string>();
    if (!ReadableFolders{{folder_}}.contain(file))
        return problem(place, "tolerance.image-outside", "must lie in the tolerance's folder or below");
    set.images.push_back(file);
}

PixelSet Parser::pixelSet(const Json& json, const std::string& place) {
    PixelSet set;
    if (!json.is_object() || json.empty()) {
        problem(place, "tolerance.set-invalid",
                "must be an object with some of rectangles, images and silhouette");
        return set;
    }
    unknownKeys(json, place, {"rectangles", "images", "silhouette"});
    if (const auto found = json.find("rectangles"); found != json.end())
        each(*found, place + "/rectangles",
             [&](const Json& r, const std::string& at) { rectangle(set, r, at); });
    if (const auto found = json.find("images"); found != json.end())
        each(*found, place + "/images", [&](const Json& i, const std::string& at) { image(set, i, at); });
    if (const auto found = json.find("silhouette"); found != json.end()) {
        if (found->is_number_integer() && *found >= 1 && *found <= 100)
            set.silhouette = *found;
        else
            problem(place + "/silhouette", "tolerance.silhouette-invalid",
                    "must be a whole number of pixels from 1 to 100");
    }
    return set;
}

void Parser::pixelsOver(Condition& c, const Json& json, const std::string& place) {
    if (!json.is_object() || !json.contains("threshold") ||
        json.contains("count") == json.contains("fraction"))
        return problem(place, "tolerance.pixels-over-invalid",
                       "must be an object with a threshold and either a count or a fraction");
    unknownKeys(json, place, {"threshold", "count", "fraction"});
    c.threshold = limit(json["threshold"], place + "/threshold");
    const char* const key = json.contains("count") ? "count" : "fraction";
    c.limit = limit(json[key], fmt::format("{}/{}", place, key));
    if (json.contains("count")) return;
    c.kind = Condition::Kind::pixelFraction;
    if (c.limit > 1)
        problem(place + "/fraction", "tolerance.fraction-above-1",
                fmt::format("must be at most 1, got {}", c.limit));
}

void Parser::group(Condition& c, const Json& json, const std::string& place) {
    if (groupDepth_ == maxGroupDepth)
        return problem(place, "tolerance.too-deep",
                       fmt::format("groups must be at most {} levels deep", maxGroupDepth));
    ++groupDepth_;
    each(json, place,
         [&](const Json& part, const std::string& at) { c.parts.push_back(condition(part, at)); });
    --groupDepth_;
}

void Parser::body(Condition& c, const char* key, const Json& json, const std::string& place) {
    if (c.isGroup())
        group(c, json, place);
    else if (std::string_view(key) == "pixels_over")
        pixelsOver(c, json, place);
    else
        c.limit = limit(json, place);
}

Condition Parser::condition(const Json& json, const std::string& place, bool isRoot) {
    Condition c;
    c.pointer = place;
    if (!json.is_object()) {
        problem(place, "tolerance.condition-invalid", "a condition must be an object");
        return c;
    }
    int found = 0;
    for (const auto& [key, kind] : kinds) {
        if (!json.contains(key)) continue;
        if (++found > 1) continue;
        c.kind = kind;
        body(c, key, json[key], place + "/" + key);
    }
    if (found != 1)
        problem(place, "tolerance.condition-invalid",
                fmt::format("a condition needs exactly one of all, any, max_abs, rmse, flip_mean and "
                            "pixels_over, got {}",
                            found));
    for (const auto& [key, set] : {std::pair{"only", &c.only}, std::pair{"except", &c.except}})
        if (json.contains(key)) *set = pixelSet(json[key], fmt::format("{}/{}", place, key));
    if (const auto reason = json.find("reason"); reason != json.end()) {
        if (reason->is_string() && !reason->get_ref<const std::string&>().empty())
            c.reason = *reason;
        else
            problem(place + "/reason", "tolerance.reason-invalid", "must be a text that says why");
    }
    for (const auto& [key, value] : json.items()) {
        constexpr std::string_view known[] = {"all",         "any",  "max_abs", "rmse",  "flip_mean",
                                              "pixels_over", "only", "except",  "reason"};
        if (std::find(std::begin(known), std::end(known), key) == std::end(known) &&
            !(isRoot && key == "$schema"))
            problem(place + "/" + key, "tolerance.unknown-key", fmt::format("'{}' means nothing here", key));
    }
    return c;
}

bool isDefault(const Condition& c) {
    const bool isStrict =
        (c.kind == Condition::Kind::maxAbs && c.limit == defaultThreshold) ||
        (c.kind == Condition::Kind::pixelCount && c.limit == 0 && c.threshold == defaultThreshold);
    return isStrict;
}

/// Every condition that is not the default, masks included, says why, itself or by a group that it is in.
void demandReasons(const Condition& c, bool isGiven, bool isMasked, std::vector<ToleranceProblem>& problems) {
    isGiven = isGiven || !c.reason.empty();
    isMasked = isMasked || !c.only.empty() || !c.except.empty();
    for (const Condition& part : c.parts) demandReasons(part, isGiven, isMasked, problems);
    if (!c.isGroup() && !isGiven && (isMasked || !isDefault(c)))
        problems.push_back({c.pointer, "tolerance.reason-missing",
                            "it is not the default (max_abs 4/65535 everywhere) and needs a \"reason\""});
}

double smallestThreshold(const Condition& c) {
    switch (c.kind) {
    case Condition::Kind::maxAbs: return c.limit;
    case Condition::Kind::pixelCount:
    case Condition::Kind::pixelFraction: return c.threshold;
    default: break;
    }
    double smallest = std::numeric_limits<double>::infinity();
    for (const Condition& part : c.parts) smallest = std::min(smallest, smallestThreshold(part));
    return smallest;
}

std::string joined(const std::filesystem::path& file, const std::vector<ToleranceProblem>& problems) {
    std::string text;
    for (const ToleranceProblem& p : problems)
        text +=
            fmt::format("{}{}{}{}: error: {} [{}]", text.empty() ? "" : "\n", file.string(),
                        p.place.starts_with('/') || p.place.empty() ? "#" : ":", p.place, p.message, p.code);
    return text;
}

Json jsonOf(std::string_view text, const std::filesystem::path& file) {
    try {
        return Json::parse(text);
    } catch (const Json::parse_error& error) {
        const auto at = Source("", std::string(text)).position(error.byte == 0 ? 0 : error.byte - 1);
        throw ToleranceError(
            file, {{fmt::format("{}:{}", at.line, at.column), "tolerance.not-json", "this is not JSON"}});
    } catch (const Json::out_of_range&) { // which does not say where
        throw ToleranceError(file, {{"", "tolerance.number-too-large", "a number in it is beyond 1.8e308"}});
    }
}

} // namespace

ToleranceError::ToleranceError(const std::filesystem::path& file, std::vector<ToleranceProblem> problems)
    : std::runtime_error(joined(file, problems)), problems_(std::move(problems)) {}

Tolerance parseTolerance(std::string_view text, const std::filesystem::path& file) {
    Parser parser(std::filesystem::absolute(file).parent_path());
    Tolerance tolerance;
    tolerance.condition = parser.condition(jsonOf(text, file), "", true);
    tolerance.source = file.string();
    if (parser.problems.empty()) demandReasons(tolerance.condition, false, false, parser.problems);
    if (!parser.problems.empty()) throw ToleranceError(file, std::move(parser.problems));
    if (const double smallest = smallestThreshold(tolerance.condition); std::isfinite(smallest))
        tolerance.threshold = smallest;
    return tolerance;
}

Tolerance readTolerance(const std::filesystem::path& file) { return parseTolerance(readFile(file), file); }

Tolerance toleranceFor(const std::filesystem::path& scene, const std::filesystem::path& named) {
    if (!named.empty()) return readTolerance(named);
    const std::filesystem::path beside = scene.parent_path() / "tolerance.json";
    return std::filesystem::exists(beside) ? readTolerance(beside) : Tolerance{};
}

} // namespace yarte::validate
