#include "convert/povray/sdl/build_light.h"

#include <algorithm>

namespace yarte::convert::povray::sdl {

Light buildLight(const LightShape& light, const Affine& world, Span span, Report& report) {
    const auto tell = [&](Action action, std::string property, std::string detail,
                          std::optional<double> bound = {}) {
        report.tell("light_source", span, {std::move(property), action, std::move(detail), bound});
    };
    for (const std::string& kind : light.kinds) {
        if (kind == "shadowless") continue; // told below
        tell(Action::approximated, kind, "a point light at its place, of its colour in all directions");
    }
    if (light.isShadowless) tell(Action::approximated, "shadowless", "it casts shadows and highlights");
    if (light.looksLike) tell(Action::dropped, "looks_like", "the light itself is not seen");
    Colour c = light.colour;
    if (const double least = std::min({c.r, c.g, c.b}); least < 0) {
        tell(Action::approximated, "colour", "negative channels become 0", -least);
        c = {std::max(c.r, 0.0), std::max(c.g, 0.0), std::max(c.b, 0.0)};
    }
    return {mapPoint(world, light.position), c, span};
}

} // namespace yarte::convert::povray::sdl
