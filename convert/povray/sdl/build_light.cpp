#include "convert/povray/sdl/build_light.h"

#include "convert/povray/sdl/body_extent.h"
#include "convert/povray/sdl/stretch.h"
#include "yarte/base/number.h"

#include <fmt/format.h>

#include <algorithm>

namespace yarte::convert::povray::sdl {
namespace {

/// In units of the reach of the bodies: parallel rays part by no more than its inverse, which no file of 16
/// bits shows.
constexpr double farAway = 1e6;

} // namespace

std::optional<BuiltLight> buildLight(const LightShape& light, const Affine& world, Span span,
                                     Report& report) {
    const auto tell = [&](Action action, std::string property, std::string detail,
                          std::optional<double> bound = {}) {
        report.tell("light_source", span, {std::move(property), action, std::move(detail), bound});
    };
    BuiltLight built{{mapPoint(world, light.position), light.colour, span}, {}};
    if (light.pointAt) {
        const Vec3 way = mapPoint(world, *light.pointAt) - built.light.position;
        if (way == Vec3{}) {
            tell(Action::dropped, "everything",
                 "parallel rays from its place to the same place light nothing");
            return std::nullopt;
        }
        built.rays = unit(way);
    }
    for (const std::string& kind : light.kinds) {
        if (kind == "parallel" || (kind == "spotlight" && built.rays)) continue; // parallel rays have no cone
        if (kind == "cylinder")
            tell(Action::approximated, kind, "its parallel rays are everywhere");
        else
            tell(Action::approximated, kind, "a point light at its place, of its colour in all directions");
    }
    if (light.isShadowless) tell(Action::approximated, "shadowless", "it casts shadows and highlights");
    if (light.looksLike) tell(Action::dropped, "looks_like", "the light itself is not seen");
    Colour& c = built.light.brightness;
    if (const double least = std::min({c.r, c.g, c.b}); least < 0) {
        tell(Action::approximated, "colour", "negative channels become 0", -least);
        c = {std::max(c.r, 0.0), std::max(c.g, 0.0), std::max(c.b, 0.0)};
    }
    return built;
}

Light placed(const BuiltLight& built, const Scene& bodies, Report& report) {
    Light light = built.light;
    if (!built.rays) return light;
    const Reach reach = reachOf(bodies, light.position, *built.rays);
    const double size = reach.distance > 0 ? reach.distance : 1, distance = farAway * size;
    const auto tell = [&](std::string detail, std::optional<double> bound) {
        report.tell("light_source", light.span, {"parallel", Action::approximated, std::move(detail), bound});
    };
    tell(fmt::format("a point light {} away; in radians", printNumber(distance)), size / (distance - size));
    if (reach.nearest < 0 || reach.hasPlane) tell("what lies behind the light's plane casts shadows too", {});
    light.position = light.position - *built.rays * distance;
    return light;
}

} // namespace yarte::convert::povray::sdl
