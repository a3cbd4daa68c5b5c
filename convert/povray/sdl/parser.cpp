#include "convert/povray/sdl/parser.h"

#include "convert/povray/sdl/words.h"

#include <fmt/format.h>

#include <algorithm>

namespace yarte::convert::povray::sdl {
namespace {

constexpr double displayGamma = 2.2;

template <typename T> Value shared(T value) { return std::make_shared<const T>(std::move(value)); }

/// Statements of the scene that YARTE has no part for.
bool isDropped(std::string_view word) {
    for (const std::string_view w : {"fog", "rainbow", "media", "photons", "radiosity", "light_group"})
        if (word == w) return true;
    return false;
}

/// Extents of an object's parts.
struct Box {
    std::optional<std::array<Vec3, 2>> box{};

    void add(Vec3 p) {
        if (!box) box = {p, p};
        auto& [low, high] = *box;
        low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
    /// The corners of a box, mapped: what POV-Ray takes for the extent of what was transformed.
    void add(const Affine& map, const std::array<Vec3, 2>& of) {
        for (unsigned corner = 0; corner < 8; ++corner)
            add(mapPoint(map, {of[corner & 1].x, of[corner >> 1 & 1].y, of[corner >> 2].z}));
    }
};

std::optional<std::array<Vec3, 2>> ownExtent(const ObjectShape& shape);

std::optional<std::array<Vec3, 2>> fullExtent(const Object& object) {
    const auto own = ownExtent(object.shape);
    if (!own || object.transform == Affine{}) return own;
    Box box;
    box.add(object.transform, *own);
    return box.box;
}

std::optional<std::array<Vec3, 2>> ownExtent(const ObjectShape& shape) {
    Box box;
    if (const auto* s = std::get_if<SphereShape>(&shape)) {
        const Vec3 r{s->radius, s->radius, s->radius};
        box.add(s->centre - r), box.add(s->centre + r);
    } else if (const auto* b = std::get_if<BoxShape>(&shape)) {
        box.add(b->a), box.add(b->b);
    } else if (const auto* c = std::get_if<ConeShape>(&shape)) {
        const Vec3 axis = c->b - c->a;
        const double l = length(axis);
        const auto spread = [&](double component) {
            return l == 0 ? 1.0 : std::sqrt(std::max(0.0, 1 - component * component / (l * l)));
        };
        const Vec3 r{spread(axis.x), spread(axis.y), spread(axis.z)};
        box.add(c->a - r * c->radiusA), box.add(c->a + r * c->radiusA);
        box.add(c->b - r * c->radiusB), box.add(c->b + r * c->radiusB);
    } else if (const auto* d = std::get_if<DiscShape>(&shape)) {
        const Vec3 r{d->radius, d->radius, d->radius};
        box.add(d->centre - r), box.add(d->centre + r);
    } else if (const auto* t = std::get_if<TorusShape>(&shape)) {
        const double r = t->major + t->minor;
        box.add({-r, -t->minor, -r}), box.add({r, t->minor, r});
    } else if (const auto* p = std::get_if<PolygonShape>(&shape)) {
        for (const auto& contour : p->contours)
            for (const Vec3 v : contour) box.add(v);
    } else if (const auto* triangle = std::get_if<TriangleShape>(&shape)) {
        for (const Vec3 v : triangle->corners) box.add(v);
    } else if (const auto* mesh = std::get_if<std::shared_ptr<const MeshShape>>(&shape)) {
        for (const Vec3 v : (*mesh)->vertices) box.add(v);
    } else if (const auto* all = std::get_if<UnionShape>(&shape)) {
        for (const ObjectPtr& part : all->parts) {
            if (std::holds_alternative<LightShape>(part->shape)) continue;
            const auto of = fullExtent(*part);
            if (!of) return std::nullopt;
            box.add((*of)[0]), box.add((*of)[1]);
        }
    }
    return box.box;
}

} // namespace

std::optional<std::array<Vec3, 2>> Parser::extent(const Object& object) { return fullExtent(object); }

std::optional<Value> Parser::value(Interpreter& in) {
    const Token& token = in.peek();
    if (token.kind != TokenKind::word || token.symbol) return std::nullopt;
    const std::string_view w = token.text;
    if (isObjectKeyword(w)) return object(in);
    if (w == "texture") {
        Layers layers;
        while (in.peekTail().isWord("texture")) {
            in.next();
            const Layers more = texture(in);
            layers.insert(layers.end(), more.begin(), more.end());
        }
        return shared(std::move(layers));
    }
    if (w == "pigment") {
        in.next();
        in.expect('{');
        Pigment made;
        pigment(in, made);
        return shared(std::move(made));
    }
    if (w == "finish") {
        in.next();
        in.expect('{');
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
    for (const std::string_view kind : {"normal", "media", "density", "fog", "rainbow", "sky_sphere", "normal_map",
                                        "slope_map", "density_map", "warp", "photons"})
        if (w == kind) {
            in.next();
            in.expect('{');
            in.skipBlock();
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
            in.expect('{');
            pigment(in, texture.pigment);
        } else if (in.accept("finish")) {
            in.expect('{');
            finish(in, texture.finish);
        } else if (in.accept("camera")) {
            in.expect('{');
            in.skipBlock();
        } else {
            const Token word = in.next(); // normal, radiosity
            if (word.kind != TokenKind::word) in.fail("sdl.unexpected", "expected texture, pigment or finish", word.span);
            in.expect('{');
            in.skipBlock();
        }
    }
}

void Parser::addObject(Interpreter& in, ObjectPtr object) {
    // Axes as YARTE's file had them, kept beside the rotation that they stand for. What is seen decides.
    if (object->exactAxes) object = withWrittenAxes(in, *object);
    if (!std::holds_alternative<LightShape>(object->shape)) ++bodies_;
    model_.objects.push_back(std::move(object));
}

void Parser::dropStatement(Interpreter& in, const Token& word) {
    in.expect('{');
    in.skipBlock();
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
                in.expect('{');
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
    // Colours are those of a display with this exponent; the picture is for one of 2.2.
    if (!model_.gamma && assumedGamma_) model_.gamma = displayGamma / *assumedGamma_;
    return std::move(model_);
}

} // namespace yarte::convert::povray::sdl
