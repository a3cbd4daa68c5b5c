#include "yarte/scene/check.h"

#include "yarte/base/number.h"
#include "yarte/scene/referential.h"
#include "yarte/scene/rules.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace yarte {
namespace {

std::string text(Vec3 v) {
    return fmt::format("{} {} {}", printNumber(v.x), printNumber(v.y), printNumber(v.z));
}

} // namespace

Problems check(const Resolution& r) {
    Rules rules;
    const auto side = [&](const char* name, int value, int argument) {
        if (value < 1 || value > maxSide)
            rules.broken({"scene.resolution-out-of-range",
                          fmt::format("image {} must be from 1 to {} pixels, got {}", name, maxSide, value),
                          argument});
    };
    side("width", r.width, 0);
    side("height", r.height, 1);
    return std::move(rules).problems();
}

Problems check(const Light& light) {
    Rules rules;
    const Colour b = light.brightness;
    rules.finite(0, light.position);
    if (rules.finite(3, {b.r, b.g, b.b})) rules.colour("brightness", b, 3);
    return std::move(rules).problems();
}

Problems check(const Material& m) {
    Rules rules;
    const Colour a = m.ambient, d = m.diffuse, s = m.specular;
    if (!rules.finite(0, {a.r, a.g, a.b, d.r, d.g, d.b, s.r, s.g, s.b, m.exponent, m.reflection,
                          m.transmission, m.index, m.tint.r, m.tint.g, m.tint.b}))
        return std::move(rules).problems();
    rules.colour("ambient colour", a, 0);
    rules.colour("diffuse colour", d, 3);
    rules.colour("specular colour", s, 6);
    rules.notNegative("scene.exponent-negative", "the Phong exponent", m.exponent, 9);
    rules.notNegative("scene.coefficient-negative", "the reflection coefficient", m.reflection, 10);
    rules.notNegative("scene.coefficient-negative", "the transmission coefficient", m.transmission, 11);
    if (m.transmission > 0)
        rules.positive("scene.index-not-positive", "the refraction index of a material that transmits",
                       m.index, 12);
    rules.colour("tint", m.tint, 13);
    return std::move(rules).problems();
}

Problems checkTint(Colour tint) {
    Rules rules;
    if (rules.finite(0, {tint.r, tint.g, tint.b})) rules.colour("tint", tint, 0);
    return std::move(rules).problems();
}

Problems check(const BackColours& back) {
    Rules rules;
    const Colour a = back.ambient, d = back.diffuse, s = back.specular;
    if (!rules.finite(0, {a.r, a.g, a.b, d.r, d.g, d.b, s.r, s.g, s.b})) return std::move(rules).problems();
    rules.colour("ambient colour", a, 0);
    rules.colour("diffuse colour", d, 3);
    rules.colour("specular colour", s, 6);
    return std::move(rules).problems();
}

Problems check(const Referential& r) {
    Rules rules;
    const bool finite = rules.finite(0, r.x) & rules.finite(3, r.y) & (!r.z || rules.finite(6, *r.z));
    if (finite)
        if (auto error = referentialError(r))
            rules.broken({"scene.bad-axes", std::move(*error), 0, r.z ? 9 : 6});
    return std::move(rules).problems();
}

Problems check(const Camera& camera) {
    Rules rules;
    if (!rules.finite(0, camera.position) | !rules.finite(1, camera.focus) | !rules.finite(2, camera.up))
        return std::move(rules).problems();
    if (camera.position == camera.focus)
        rules.broken({"scene.position-is-focus",
                      "the camera's position and its focus point must differ, both are " + text(camera.focus),
                      1});
    if (camera.up == Vec3{})
        rules.broken({"scene.up-zero", "the up vector must not be of length 0", 2});
    else if (camera.position != camera.focus &&
             length(cross(unitVector(camera.up), unitVector(camera.focus - camera.position))) < minUpSine)
        rules.broken(
            {"scene.up-parallel",
             fmt::format("the up vector must not be parallel to the view direction, got {}", text(camera.up)),
             2});
    return std::move(rules).problems();
}

Problems checkApertures(double horizontalDegrees, double verticalDegrees) {
    Rules rules;
    const auto aperture = [&](const char* name, double degrees, int argument) {
        if (rules.finite(argument, {degrees}) && !(degrees > 0 && degrees < 90))
            rules.broken({"scene.aperture-out-of-range",
                          fmt::format("the {} aperture must be between 0 and 90 degrees (it is measured from "
                                      "the view axis), got {}",
                                      name, printNumber(degrees)),
                          argument});
    };
    aperture("horizontal", horizontalDegrees, 0);
    aperture("vertical", verticalDegrees, 1);
    return std::move(rules).problems();
}

Problems checkBackground(Colour c) {
    Rules rules;
    if (rules.finite(0, {c.r, c.g, c.b})) rules.colour("background colour", c, 0);
    return std::move(rules).problems();
}

Problems checkRecursion(int levels) {
    Rules rules;
    if (levels < 0 || levels > maxRecursionLimit)
        rules.broken(
            {"scene.recursion-out-of-range",
             fmt::format("the recursion level must be from 0 to {}, got {}", maxRecursionLimit, levels), 0});
    return std::move(rules).problems();
}

Problems checkGamma(double gamma) {
    Rules rules;
    if (rules.finite(0, {gamma})) rules.positive("scene.gamma-not-positive", "gamma", gamma, 0);
    return std::move(rules).problems();
}

} // namespace yarte
