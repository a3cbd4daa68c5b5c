#include "yarte/lang/scene_builder.h"

#include "yarte/base/number.h"
#include "yarte/lang/argument_reader.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <utility>

namespace yarte {

void SceneBuilder::add(const Statement& s) {
    if (s.directive == nullptr) {
        unknownMaterial_ = unknownBody_ = unknownTint_ = true;
        return;
    }
    // A setting with errors, or given again, leaves the scene as it is.
    const bool set = s.directive->once && isFirst(s) && s.good;
    ArgumentReader read(s);
    Camera& camera = scene_.camera;
    switch (s.directive->keyword) {
    case Keyword::imageResolution:
        if (set) setResolution(s);
        return;
    case Keyword::cameraPosition:
        if (set) camera.position = read.vec3();
        return;
    case Keyword::cameraApertures:
        if (set)
            camera.horizontalApertureDegrees = read.number(), camera.verticalApertureDegrees = read.number();
        if (set) report(checkApertures(camera.horizontalApertureDegrees, camera.verticalApertureDegrees), s);
        return;
    case Keyword::focusPoint:
        if (set) camera.focus = read.vec3();
        return;
    case Keyword::upVector:
        if (set) camera.up = read.vec3();
        return;
    case Keyword::backgroundColour:
        if (set) report(checkBackground(scene_.background = read.colour()), s);
        return;
    case Keyword::maxRecurseLevel:
        if (set) setRecursion(s);
        return;
    case Keyword::gammaCorrectionFactor:
        if (set) report(checkGamma(scene_.gamma = read.number()), s);
        return;
    case Keyword::lightSource: return addLight(s);
    case Keyword::material: return addMaterial(s);
    case Keyword::tint: return addTint(s);
    case Keyword::sphere:
    case Keyword::box:
    case Keyword::cone:
    case Keyword::truncatedCone:
    case Keyword::disc:
    case Keyword::polygon:
    case Keyword::mesh:
    case Keyword::cylinder:
    case Keyword::openCylinder:
    case Keyword::frustum:
    case Keyword::plane: return addBody(s);
    case Keyword::backfaceColour: return addBackColours(s);
    case Keyword::instanceReferential: return addReferential(s);
    }
}

bool SceneBuilder::isFirst(const Statement& s) {
    std::optional<Given>& first = given(s.directive->keyword);
    if (!first) {
        first = {s.whole, s.good};
        return true;
    }
    diagnostics_
        .error("scene.duplicate-directive", fmt::format("{} must be given only once", s.directive->name),
               s.whole)
        .notes.push_back({"first given here", first->span});
    return false;
}

std::optional<int> SceneBuilder::wholeNumber(const Argument& argument) {
    constexpr int largest = std::numeric_limits<int>::max();
    if (argument.value != std::floor(argument.value))
        diagnostics_.error(
            "lang.not-a-whole-number",
            fmt::format("a whole number is expected here, got {}", printNumber(argument.value)),
            argument.span);
    else if (std::abs(argument.value) > largest)
        diagnostics_.error(
            "lang.number-too-large",
            fmt::format("a whole number must not exceed {}, got {}", largest, printNumber(argument.value)),
            argument.span);
    else
        return static_cast<int>(argument.value);
    return std::nullopt;
}

void SceneBuilder::report(const Problems& problems, const Statement& s) {
    for (const Problem& problem : problems) {
        Span span = s.whole;
        if (problem.argument >= 0) {
            const auto first = static_cast<std::size_t>(problem.argument);
            if (first >= s.arguments.size()) continue; // a light's one brightness is checked as three
            const auto count = static_cast<std::size_t>(problem.argumentCount);
            const auto last = std::min(first + count, s.arguments.size()) - 1;
            span = {span.source, s.arguments[first].span.begin, s.arguments[last].span.end};
        }
        diagnostics_.error(problem.code, problem.message, span);
    }
}

void SceneBuilder::setResolution(const Statement& s) {
    const std::optional<int> width = wholeNumber(s.arguments[0]), height = wholeNumber(s.arguments[1]);
    if (width && height) report(check(scene_.resolution = {*width, *height}), s);
}

void SceneBuilder::setRecursion(const Statement& s) {
    if (const auto levels = wholeNumber(s.arguments[0]))
        report(checkRecursion(scene_.maxRecursion = *levels), s);
}

void SceneBuilder::checkCamera() {
    const auto &position = given(Keyword::cameraPosition), &focus = given(Keyword::focusPoint),
               &up = given(Keyword::upVector);
    if (!position || !position->good || !focus || !focus->good || (up && !up->good)) return;
    const Span places[] = {position->span, focus->span, up ? up->span : focus->span};
    for (const Problem& problem : check(scene_.camera))
        diagnostics_.error(problem.code, problem.message, places[problem.argument]);
}

std::optional<Scene> SceneBuilder::finish(const Source& text) && {
    for (const Keyword keyword : {Keyword::cameraPosition, Keyword::focusPoint})
        if (!given(keyword))
            diagnostics_
                .error("scene.missing-directive", fmt::format("{} must be given", directive(keyword).name))
                .file = text.name();
    checkCamera();
    if (scene_.lights.empty())
        diagnostics_.warning("scene.no-light", "the scene has no light_source: only ambient colours are seen")
            .file = text.name();
    if (scene_.bodies.empty())
        diagnostics_.warning("scene.no-object", "the scene has no object: only the background is seen").file =
            text.name();
    if (diagnostics_.hasErrors()) return std::nullopt;
    return std::move(scene_);
}

} // namespace yarte
