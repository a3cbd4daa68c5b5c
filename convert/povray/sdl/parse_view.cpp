// Lights, settings.

#include "convert/povray/sdl/parser.h"

#include <algorithm>

namespace yarte::convert::povray::sdl {
LightShape Parser::light(Interpreter& in) {
    LightShape light;
    Vec3 pointAt{0, 0, 1};
    bool isParallel = false;
    light.position = in.point();
    in.comma();
    const Rgbft c = in.colour();
    light.colour = {c.r, c.g, c.b};
    while (!in.peek().is('}')) {
        if (const auto transformation = acceptTransformation(in)) {
            // At once: a point_at that comes later is not moved.
            light.position = mapPoint(*transformation, light.position);
            pointAt = mapPoint(*transformation, pointAt);
            continue;
        }
        if (in.accept(',')) continue;
        if (in.peek().kind != TokenKind::word) in.failExpected("a word of light_source, such as spotlight");
        const Token word = in.next();
        const std::string_view w = word.text;
        if (w == "looks_like") {
            in.expect('{');
            light.looksLike = this->object(in);
            Object copy = light.looksLike ? *light.looksLike : Object{};
            modifiers(in, copy);
        } else if (w == "shadowless") {
            light.isShadowless = true;
        } else if (w == "spotlight" || w == "cylinder" || w == "parallel" || w == "area_light" ||
                   w == "fade_distance" || w == "fade_power" || w == "projected_through") {
            light.kinds.emplace_back(w);
            isParallel |= w == "parallel" || w == "cylinder";
            if (w == "area_light") {
                in.vector3(), in.comma(), in.vector3(), in.comma(), in.number(), in.comma(), in.number();
            } else if (w == "projected_through") {
                in.skipBraces();
            } else if (w == "fade_distance" || w == "fade_power") {
                in.number();
            }
        } else if (w == "point_at") {
            pointAt = in.vector3();
        } else if (w == "media_attenuation" || w == "media_interaction" || w == "area_illumination") {
            optionalFlag(in);
        } else if (in.accept('{')) {
            in.skipBlock();
        } else if (w != "jitter" && w != "circular" && w != "orient" && in.startsExpression()) {
            in.expression();
        }
    }
    if (isParallel) light.pointAt = pointAt;
    return light;
}

void Parser::globalSettings(Interpreter& in) {
    in.expect('{');
    while (!in.accept('}')) {
        const Token word = in.next();
        if (word.kind == TokenKind::end)
            in.fail("sdl.no-brace", "global_settings has no closing brace", word.span);
        if (word.text == "ambient_light") {
            const Rgbft c = in.colour();
            model_.ambientLight = {c.r, c.g, c.b};
        } else if (word.text == "max_trace_level") {
            model_.maxTraceLevel = std::clamp(in.integer(), 1, 256);
        } else if (word.text == "radiosity" || word.text == "photons" || word.text == "subsurface") {
            in.skipBraces();
            in.report(word.span, std::string(word.text), "not in YARTE's model of light");
        } else if (word.text == "charset") {
            in.next();
        } else if (in.accept('{')) {
            in.skipBlock();
        } else if (word.kind == TokenKind::word && in.startsExpression()) {
            if (word.text == "assumed_gamma") {
                if (const double gamma = in.number(); gamma > 0) model_.assumedGamma = gamma;
            } else if (word.text == "adc_bailout")
                in.number();
            else
                in.colour();
        }
    }
}

} // namespace yarte::convert::povray::sdl
