#include "convert/povray/sdl/parser.h"

#include "convert/povray/sdl/object_extent.h"
#include "convert/povray/sdl/words.h"

#include <fmt/format.h>

#include <algorithm>

namespace yarte::convert::povray::sdl {
namespace {

template <typename T>
Value shared(T value) {
    return std::make_shared<const T>(std::move(value));
}

/// Statements of the scene that YARTE has no part for.
bool isDropped(std::string_view word) {
    for (const std::string_view w : {"fog", "rainbow", "media", "photons", "radiosity", "light_group"})
        if (word == w) return true;
    return false;
}

} // namespace

std::optional<std::array<Vec3, 2>> Parser::extent(const Object& object) { return extentOf(object); }

std::optional<Value> Parser::value(Interpreter& in) {
    const Token& token = in.peek();
    if (token.kind != TokenKind::word || token.symbol) return std::nullopt;
    const std::string_view w = token.text;
    if (isObjectKeyword(w)) return object(in);
    if (w == "texture") {
        std::optional<Layers> layers;
        while (in.peekTail().isWord("texture")) {
            in.next();
            putOn(in, layers, texture(in));
        }
        return shared(std::move(*layers));
    }
    if (w == "pigment") {
        in.next();
        Pigment made;
        pigment(in, made);
        return shared(std::move(made));
    }
    if (w == "finish") {
        in.next();
        Finish made = defaultTexture().finish;
        finish(in, made);
        return shared(std::move(made));
    }
    if (w == "interior") {
        in.next();
        Interior made;
        interior(in, made);
        return shared(std::move(made));
    }
    if (w == "material") {
        in.next();
        Appearance made;
        material(in, made);
        return shared(std::move(made));
    }
    if (w == "transform") return shared(*acceptTransformation(in));
    if (w == "camera") {
        const Span span = in.next().span;
        return shared(camera(in, span));
    }
    if (w == "color_map" || w == "colour_map") {
        in.next();
        return shared(colourMap(in));
    }
    if (w == "pigment_map" || w == "texture_map") {
        in.next();
        return shared(textureMap(in));
    }
    for (const std::string_view kind : {"normal", "media", "density", "fog", "rainbow", "sky_sphere",
                                        "normal_map", "slope_map", "density_map", "warp", "photons"})
        if (w == kind) {
            in.next();
            in.skipBraces();
            return shared(OpaqueValue{std::string(kind)});
        }
    return std::nullopt;
}

void Parser::defaults(Interpreter& in) {
    Texture& texture = model_.defaultTexture;
    while (!in.accept('}')) {
        if (in.accept("texture")) {
            texture = this->texture(in).back();
        } else if (in.accept("pigment")) {
            pigment(in, texture.pigment);
        } else if (in.accept("finish")) {
            finish(in, texture.finish);
        } else if (in.accept("camera")) {
            in.skipBraces();
        } else {
            const Token word = in.next(); // normal, radiosity
            if (word.kind != TokenKind::word)
                in.fail("sdl.unexpected", "expected texture, pigment or finish", word.span);
            in.skipBraces();
        }
    }
}

void Parser::addObject(Interpreter& in, ObjectPtr object) {
    shown_ += object->count;
    if (shown_ > in.environment().limits.objects) failTooManyObjects(in, object->span);
    // Axes as YARTE's file had them, kept beside the rotation that they stand for. What is seen decides.
    if (object->exactAxes) object = withWrittenAxes(in, *object);
    if (!std::holds_alternative<LightShape>(object->shape)) ++bodies_;
    model_.objects.push_back(std::move(object));
}

void Parser::dropStatement(Interpreter& in, const Token& word) {
    in.skipBraces();
    in.report(word.span, std::string(word.text), "not in YARTE's model");
}

void Parser::statement(Interpreter& in) {
    if (in.accept(';')) return;
    if (auto camera = in.acceptNamed<Shared<CameraModel>>()) { // by a known macro
        model_.camera = **camera;
        return;
    }
    if (ObjectPtr made = object(in)) return addObject(in, std::move(made));
    const Token word = in.next();
    if (word.isWord("camera")) {
        model_.camera = camera(in, word.span);
    } else if (word.isWord("background")) {
        in.expect('{');
        const Rgbft c = in.colour();
        in.expect('}');
        model_.background = {c.r, c.g, c.b};
    } else if (word.isWord("default")) { // without a '#', as POV-Ray 1 had it
        in.expect('{');
        defaults(in);
    } else if (word.isWord("global_settings")) {
        globalSettings(in);
    } else if (word.isWord("sky_sphere")) {
        Pigment sky;
        in.expect('{');
        while (!in.accept('}')) {
            if (in.accept("pigment")) {
                pigment(in, sky);
            } else if (!acceptTransformation(in)) {
                in.next();
            }
        }
        model_.background = {sky.colour.r, sky.colour.g, sky.colour.b};
        in.report(word.span, "sky_sphere", "its mean colour is the background");
    } else if (word.kind == TokenKind::word && isDropped(word.text)) {
        dropStatement(in, word);
    } else {
        in.putBack(word);
        in.failExpected("an object, camera, light_source or another statement");
    }
}

Model Parser::parse(Interpreter& in) {
    model_ = {};
    while (!in.atEnd()) statement(in);
    in.closeFiles();
    return std::move(model_);
}

} // namespace yarte::convert::povray::sdl
