// Textures, pigments, finishes, interiors, materials.

#include "convert/povray/sdl/parser.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace yarte::convert::povray::sdl {
namespace {

constexpr std::string_view patterns[] = {
    "agate",         "aoi",        "average",         "boxed",    "bozo",        "brick",        "bumps",
    "cells",         "checker",    "crackle",         "cubic",    "cylindrical", "density_file", "dents",
    "facets",        "fractal",    "function",        "gradient", "granite",     "hexagon",      "image_map",
    "image_pattern", "julia",      "leopard",         "magnet",   "mandel",      "marble",       "object",
    "onion",         "pavement",   "pigment_pattern", "planar",   "proximity",   "quilted",      "radial",
    "ripples",       "slope",      "spherical",       "spiral1",  "spiral2",     "spotted",      "square",
    "tiling",        "triangular", "waves",           "wood",     "wrinkles",    "bump_map",
};

bool isPattern(const Token& token) {
    return token.kind == TokenKind::word && !token.symbol &&
           std::ranges::find(patterns, token.text) != std::end(patterns);
}

/// Patterns of whole colours, listed one after another.
bool isListPattern(std::string_view pattern) {
    return pattern == "checker" || pattern == "brick" || pattern == "hexagon" || pattern == "square" ||
           pattern == "triangular" || pattern == "object" || pattern == "cubic";
}

struct Mean {
    Rgbft sum{};
    double weight = 0;

    void add(const Rgbft& c, double w) {
        sum = {sum.r + w * c.r, sum.g + w * c.g, sum.b + w * c.b, sum.filter + w * c.filter,
               sum.transmit + w * c.transmit};
        weight += w;
    }
    Rgbft get() const {
        const double w = weight > 0 ? 1 / weight : 0;
        return {sum.r * w, sum.g * w, sum.b * w, sum.filter * w, sum.transmit * w};
    }
};

/// The mean over [0, 1] of what is known at places.
struct MapMean {
    Mean mean{};
    std::optional<std::pair<double, Rgbft>> last{};

    void add(double at, const Rgbft& c) {
        at = std::clamp(at, 0.0, 1.0);
        if (!last) {
            mean.add(c, at); // before the first entry its colour goes on
        } else {
            const double width = std::max(at - last->first, 0.0);
            mean.add(last->second, width / 2), mean.add(c, width / 2);
        }
        last = {at, c};
    }
    Rgbft get() {
        if (last) mean.add(last->second, std::max(1 - last->first, 1e-300));
        return mean.get();
    }
};

Colour rgb(const Rgbft& c) { return {c.r, c.g, c.b}; }

/// A word, number or block that changes nothing that is kept.
void skipItem(Interpreter& in) {
    const Token token = in.next();
    if (token.kind == TokenKind::end) in.fail("sdl.no-brace", "this block has no closing brace", token.span);
    if (token.is('{')) in.skipBlock();
}

} // namespace

ColourMap Parser::colourMap(Interpreter& in) {
    in.expect('{');
    MapMean mean;
    std::optional<ColourMap> named;
    while (!in.accept('}')) {
        if (auto map = in.acceptNamed<Shared<ColourMap>>()) {
            named = **map;
            continue;
        }
        in.expect('[');
        const double at = in.number();
        in.comma();
        // [a, b colour C colour D], as POV-Ray 1 had it, or [a C].
        std::optional<double> to;
        const Token& next = in.peek();
        if (next.kind == TokenKind::number) {
            const Vector v = in.expression();
            to = v.at[0];
            in.comma();
        }
        mean.add(at, in.colour());
        in.comma();
        if (to && !in.peek().is(']')) mean.add(*to, in.colour());
        in.expect(']');
    }
    if (named && !mean.last) return *named;
    return {mean.get()};
}

TextureMap Parser::textureMap(Interpreter& in) {
    in.expect('{');
    TextureMap map;
    while (!in.accept('}')) {
        if (auto named = in.acceptNamed<Shared<TextureMap>>()) {
            map = **named;
            continue;
        }
        in.expect('[');
        if (in.peek().isWord("function")) // the weight in an average
            in.value();
        else if (in.startsExpression())
            in.number();
        in.comma();
        Layers layers{defaultTexture()};
        bool isTexture = false;
        while (!in.peek().is(']')) {
            if (in.accept("texture")) {
                layers = texture(in);
                isTexture = true;
            } else if (auto named = in.acceptNamed<Shared<Layers>>()) {
                layers = **named;
                isTexture = true;
            } else if (in.accept("pigment")) {
                pigment(in, layers.back().pigment);
            } else if (in.accept("finish")) {
                finish(in, layers.back().finish);
            } else if (auto p = in.acceptNamed<Shared<Pigment>>()) {
                layers.back().pigment = **p;
            } else if (!isTexture && in.startsExpression()) {
                layers.back().pigment = {in.colour()};
            } else {
                skipItem(in);
            }
        }
        in.expect(']');
        if (map.first.empty()) map.first = std::move(layers);
    }
    return map;
}

void Parser::pigment(Interpreter& in, Pigment& pigment) {
    const Interpreter::Nested nested(in);
    in.expect('{');
    std::string pattern;
    Mean listed;
    while (!in.accept('}')) {
        if (auto named = in.acceptNamed<Shared<Pigment>>()) {
            if (pattern.empty())
                pigment = **named;
            else
                listed.add((*named)->colour, 1);
        } else if (auto map = in.acceptNamed<Shared<ColourMap>>()) {
            pigment = {(*map)->mean, pattern};
        } else if (acceptTransformation(in)) {
        } else if (isPattern(in.peek())) {
            pattern = in.next().text;
            pigment.pattern = pattern;
            if (pattern == "image_map") {
                pigment.colour = {0.5, 0.5, 0.5};
                in.skipBraces();
            } else if (pattern == "object") {
                in.expect('{');
                while (!in.accept('}')) {
                    if (!object(in)) skipItem(in);
                    in.comma();
                    break;
                }
                while (!in.accept('}')) {
                    if (in.startsExpression())
                        listed.add(in.colour(), 1);
                    else
                        skipItem(in);
                    in.comma();
                }
                if (listed.weight > 0) pigment.colour = listed.get();
                return;
            } else if (pattern == "gradient") {
                in.vector3();
            }
        } else if (in.accept("color_map") || in.accept("colour_map")) {
            pigment.colour = colourMap(in).mean;
            if (pattern.empty()) pigment.pattern = "color_map";
        } else if (in.accept("pigment_map")) {
            const Layers first = textureMap(in).first;
            if (!first.empty()) pigment.colour = first.back().pigment.colour;
            if (pattern.empty()) pigment.pattern = "pigment_map";
        } else if (in.accept("quick_color") || in.accept("quick_colour")) {
            in.colour();
        } else if (in.accept("pigment")) {
            Pigment part;
            this->pigment(in, part);
            listed.add(part.colour, 1);
        } else if ((pattern.empty() || isListPattern(pattern)) && in.startsExpression()) {
            const Rgbft colour = in.colour();
            in.comma();
            if (pattern.empty())
                pigment = {colour};
            else
                listed.add(colour, 1);
        } else if (in.peek().isWord("transmit") || in.peek().isWord("filter")) {
            const bool filters = in.next().text == "filter";
            (filters ? pigment.colour.filter : pigment.colour.transmit) = in.number();
        } else {
            skipItem(in); // turbulence, frequency, ... and their values
        }
    }
    if (listed.weight > 0) pigment.colour = listed.get();
}

void Parser::finish(Interpreter& in, Finish& finish) {
    const Interpreter::Nested nested(in);
    in.expect('{');
    const auto reflection = [&] {
        if (!in.accept('{')) {
            finish.reflectionMin = finish.reflectionMax = rgb(in.colour());
            return;
        }
        if (!in.peek().is('}')) {
            if (in.startsExpression()) {
                finish.reflectionMin = finish.reflectionMax = rgb(in.colour());
                in.comma();
                if (in.startsExpression()) finish.reflectionMax = rgb(in.colour());
            }
            while (!in.accept('}')) {
                if (in.accept("fresnel"))
                    finish.reflectionFresnel = optionalFlag(in);
                else if (in.accept("falloff"))
                    finish.reflectionFalloff = in.number();
                else if (in.accept("exponent"))
                    finish.reflectionExponent = in.number();
                else if (in.accept("metallic"))
                    finish.reflectionMetallic = in.startsExpression() ? in.number() : 1;
                else
                    skipItem(in);
            }
        } else {
            in.expect('}');
        }
    };
    const auto ignore = [&](std::string_view word) { finish.ignored.emplace_back(word); };
    while (!in.accept('}')) {
        if (auto named = in.acceptNamed<Shared<Finish>>())
            finish = **named;
        else if (in.accept("ambient"))
            finish.ambient = rgb(in.colour());
        else if (in.accept("emission"))
            finish.emission = rgb(in.colour());
        else if (in.accept("diffuse")) {
            if (in.accept("albedo")) ignore("albedo");
            finish.diffuse = in.number();
            if (in.accept(',')) in.number(), ignore("light from behind");
        } else if (in.accept("brilliance"))
            finish.brilliance = in.number();
        else if (in.accept("phong")) {
            if (in.accept("albedo")) ignore("albedo");
            finish.phong = in.number();
        } else if (in.accept("phong_size"))
            finish.phongSize = in.number();
        else if (in.accept("specular")) {
            if (in.accept("albedo")) ignore("albedo");
            finish.specular = in.number();
        } else if (in.accept("roughness"))
            finish.roughness = in.number();
        else if (in.accept("metallic"))
            finish.metallic = in.startsExpression() ? in.number() : 1;
        else if (in.accept("reflection"))
            reflection();
        else if (in.accept("reflection_exponent"))
            finish.reflectionExponent = in.number();
        else if (in.accept("conserve_energy"))
            finish.conserveEnergy = optionalFlag(in);
        else if (in.accept("ior"))
            finish.index = in.number();
        else if (in.accept("refraction"))
            in.number(); // of no effect since POV-Ray 3.1
        else if (in.accept("caustics") || in.accept("fade_distance") || in.accept("fade_power"))
            in.number();
        else if (in.accept("use_alpha"))
            optionalFlag(in);
        else if (in.accept("crand")) {
            if (in.number() != 0) ignore("crand");
        } else if (in.accept("irid")) {
            in.skipBraces();
            ignore("irid");
        } else if (in.accept("subsurface")) {
            in.skipBraces();
            ignore("subsurface");
        } else
            in.failExpected("a word of finish, such as ambient");
    }
}

Layers Parser::texture(Interpreter& in) {
    const Interpreter::Nested nested(in);
    in.expect('{');
    Layers layers{defaultTexture()};
    std::string pattern;
    const auto standsIn = [&](const Layers& first, std::string_view kind) {
        if (!first.empty() && layers.back().kind.empty()) {
            layers = first;
            layers.back().kind = pattern.empty() ? std::string(kind) : fmt::format("{} of {}", kind, pattern);
        }
    };
    while (!in.accept('}')) {
        if (auto named = in.acceptNamed<Shared<Layers>>()) {
            if (pattern.empty())
                layers = **named;
            else
                standsIn(**named, "textures");
        } else if (acceptTransformation(in)) {
        } else if (in.accept("pigment")) {
            pigment(in, layers.back().pigment);
        } else if (in.accept("finish")) {
            finish(in, layers.back().finish);
        } else if (in.accept("normal")) {
            in.skipBraces();
            layers.back().hasNormal = true;
        } else if (in.accept("texture_map")) {
            standsIn(textureMap(in).first, "texture_map");
        } else if (in.accept("texture")) {
            standsIn(texture(in), "textures");
        } else if (in.accept("material_map")) {
            in.skipBraces();
            layers.back().kind = "material_map";
        } else if (isPattern(in.peek())) {
            pattern = in.next().text;
        } else {
            skipItem(in);
        }
    }
    return layers;
}

void Parser::interior(Interpreter& in, Interior& interior) {
    in.expect('{');
    while (!in.accept('}')) {
        if (auto named = in.acceptNamed<Shared<Interior>>()) {
            interior = **named;
        } else if (in.accept("ior")) {
            interior.index = in.number();
        } else if (in.peek().isWord("media") || in.peek().isWord("fade_distance") ||
                   in.peek().isWord("dispersion")) {
            interior.ignored.emplace_back(in.peek().text);
            skipItem(in);
            if (in.peek().is('{')) skipItem(in);
        } else {
            skipItem(
                in); // caustics, fade_power, fade_colour, dispersion_samples: of photons and of the above
        }
    }
}

void Parser::material(Interpreter& in, Appearance& appearance) {
    in.expect('{');
    while (!in.accept('}')) {
        if (auto named = in.acceptNamed<Shared<Appearance>>()) {
            appearance = **named;
        } else if (in.accept("texture")) {
            putOn(in, appearance.layers, texture(in));
            appearance.exact.reset();
        } else if (in.accept("interior_texture")) {
            putOn(in, appearance.backLayers, texture(in));
            appearance.exact.reset();
        } else if (in.accept("interior")) {
            appearance.interior = appearance.interior.value_or(Interior{});
            interior(in, *appearance.interior);
            appearance.exact.reset();
        } else if (!acceptTransformation(in)) {
            in.failExpected("texture, interior_texture or interior");
        }
    }
}

} // namespace yarte::convert::povray::sdl
