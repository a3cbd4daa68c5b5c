#include "validate/speed/measure_rays.h"

#include "validate/compare.h"
#include "validate/speed/numbers.h"
#include "validate/speed/povray_rays.h"
#include "yarte/base/file.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace yarte::validate {

namespace {

constexpr std::string_view hitsHead = "x,y,body,distance,normal_x,normal_y,normal_z";

/// So many tests of a ray and a surface take some seconds; rays are fewer in scenes of many surfaces.
constexpr double mostTests = 1e9;

Spread spreadOf(std::vector<double> errors) {
    if (errors.empty()) return {};
    std::sort(errors.begin(), errors.end());
    double squares = 0;
    for (const double error : errors) squares += error * error;
    return {errors[errors.size() / 2], std::sqrt(squares / static_cast<double>(errors.size())),
            errors.back()};
}

double normalError(const RealVec3& truth, Vec3 normal) {
    const RealVec3 unit = normalised(RealVec3(normal)); // a float's length is only nearly 1
    return std::min(length(unit - truth), length(unit + truth)).convert_to<double>();
}

RayErrors errorsOf(std::string name, const std::vector<std::optional<TrueHit>>& truth,
                   const std::vector<RayAnswer>& answers) {
    if (answers.size() != truth.size())
        throw CaseError(fmt::format("{} rays were asked, {} answered", truth.size(), answers.size()));
    std::vector<RayPair> pairs;
    for (std::size_t i = 0; i < truth.size(); ++i) pairs.push_back({truth[i], answers[i]});
    return rayErrors(std::move(name), pairs);
}

std::vector<RayAnswer> askPovray(Workshop& workshop, const SpeedSettings& settings,
                                 const std::filesystem::path& scene, const Scene& content,
                                 const TrueScene& trueScene, const std::vector<std::optional<TrueHit>>& truth,
                                 Resolution size) {
    std::vector<RayQuestion> questions;
    std::vector<std::size_t> pixels;
    for (std::size_t i = 0; i < truth.size(); ++i) {
        if (!truth[i]) continue;
        const auto width = static_cast<std::size_t>(size.width);
        const RealRay ray = trueScene.ray(static_cast<int>(i % width), static_cast<int>(i / width));
        questions.push_back({ray.origin.rounded(), ray.direction.rounded(), truth[i]->body});
        pixels.push_back(i);
    }
    convertForPovray(workshop, settings.render, scene, 1);
    const std::string answers =
        runPovrayProgram(workshop, settings.render,
                         askingScene(readFile(workshop.file(povraySceneFile)), content.bodies.size(),
                                     questions, rayAnswersFile));
    std::vector<RayAnswer> result(truth.size());
    const std::vector<RayAnswer> answered = answersIn(answers, questions);
    for (std::size_t i = 0; i < answered.size(); ++i) result[pixels[i]] = answered[i];
    return result;
}

} // namespace

RayErrors rayErrors(std::string name, const std::vector<RayPair>& pairs) {
    RayErrors errors;
    errors.name = std::move(name);
    std::vector<double> distances, normals;
    for (const auto& [truth, answer] : pairs) {
        if (answer.body != (truth ? truth->body : -1)) {
            ++errors.otherwise;
            continue;
        }
        if (!truth) continue;
        const Real distance = abs(answer.distance - truth->distance) / truth->distance;
        distances.push_back(distance.convert_to<double>());
        normals.push_back(normalError(truth->normal, answer.normal));
    }
    errors.compared = distances.size();
    errors.distance = spreadOf(std::move(distances));
    errors.normal = spreadOf(std::move(normals));
    return errors;
}

std::vector<RayAnswer> hitsIn(std::string_view text) {
    std::vector<RayAnswer> answers;
    std::size_t line = 0;
    while (!text.empty()) {
        const std::string_view row = text.substr(0, text.find('\n'));
        text.remove_prefix(std::min(text.size(), row.size() + 1));
        if (line++ == 0) {
            if (row != hitsHead) throw CaseError("yarte --hits wrote a file that cannot be read");
            continue;
        }
        const auto numbers = numbersIn<7>(row);
        if (!numbers) throw CaseError(fmt::format("yarte --hits wrote a line that cannot be read: {}", row));
        const auto& n = *numbers;
        answers.push_back({static_cast<int>(n[2]), n[3], {n[4], n[5], n[6]}});
    }
    return answers;
}

Resolution sizeForRays(int width, int height, int rays) {
    const double scale = std::min(1.0, std::sqrt(rays / (static_cast<double>(width) * height)));
    return {std::max(1, static_cast<int>(width * scale)), std::max(1, static_cast<int>(height * scale))};
}

Rays measureRays(Workshop& workshop, const SpeedSettings& settings, const std::filesystem::path& scene,
                 const Scene& content, int width, int height) {
    Rays result;
    const double affordable =
        mostTests / static_cast<double>(std::max<std::size_t>(1, surfaceCount(content)));
    const Resolution size =
        sizeForRays(width, height, static_cast<int>(std::min<double>(settings.rays, affordable)));
    const TrueScene trueScene(content, size);
    result.width = size.width, result.height = size.height;
    std::vector<std::optional<TrueHit>> truth;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) truth.push_back(trueScene.firstHit(trueScene.ray(x, y)));
    result.met = static_cast<std::size_t>(
        std::count_if(truth.begin(), truth.end(), [](const auto& hit) { return hit.has_value(); }));
    RenderSettings render = settings.render;
    render.size = fmt::format("{}x{}", size.width, size.height);
    for (const bool fast : {false, true}) {
        render.fast = fast;
        result.programs.push_back(errorsOf(fast ? "YARTE fast" : "YARTE double", truth,
                                           hitsIn(renderHits(workshop, render, scene))));
    }
    if (!settings.withoutPovray.empty()) return result;
    try {
        result.programs.push_back(errorsOf(
            "POV-Ray", truth, askPovray(workshop, settings, scene, content, trueScene, truth, size)));
    } catch (const CaseError& error) {
        result.note = fmt::format("POV-Ray's rays are left out: {}", error.what());
    }
    return result;
}

} // namespace yarte::validate
