// Objects and what may be in their braces.

#include "convert/povray/sdl/parser.h"
#include "convert/povray/sdl/words.h"
#include "yarte/scene/referential.h"

#include <fmt/format.h>

#include <algorithm>

namespace yarte::convert::povray::sdl {

void failTooManyObjects(const Interpreter& in, Span where) {
    in.fail("sdl.objects", fmt::format("more than {} objects", in.environment().limits.objects), where);
}

void putOn(Interpreter& in, std::optional<Layers>& layers, Layers more) {
    if (!layers) {
        layers = std::move(more);
        return;
    }
    if (layers->size() + more.size() > in.environment().limits.layers)
        in.fail("sdl.layers", fmt::format("a texture of more than {} layers", in.environment().limits.layers),
                in.peekSpan());
    layers->insert(layers->end(), more.begin(), more.end());
}

std::optional<Affine> acceptTransformation(Interpreter& in) {
    if (in.accept("translate")) return translation(in.vector3());
    if (in.accept("rotate")) return rotation(in.vector3());
    if (in.accept("scale")) {
        const Span where = in.peek().span;
        const Vec3 factors = in.vector3();
        if (!isFinite(factors)) in.fail("sdl.range", "a scale that is not finite", where);
        return scaling(factors);
    }
    if (in.accept("matrix")) {
        in.expect('<');
        double m[12];
        for (double& v : m) {
            v = in.number();
            in.comma();
        }
        in.expect('>');
        return Affine{{m[0], m[1], m[2]}, {m[3], m[4], m[5]}, {m[6], m[7], m[8]}, {m[9], m[10], m[11]}};
    }
    if (!in.accept("transform")) return std::nullopt;
    if (auto named = in.acceptNamed<Shared<Affine>>()) return **named;
    const Token open = in.expect('{');
    Affine all;
    bool isInverse = false;
    while (!in.accept('}')) {
        if (auto named = in.acceptNamed<Shared<Affine>>())
            all = then(all, **named);
        else if (in.accept("inverse"))
            isInverse = true;
        else if (const auto one = acceptTransformation(in))
            all = then(all, *one);
        else
            in.failExpected("a transformation");
    }
    if (!isInverse) return all;
    const auto inverted = inverse(all);
    if (!inverted) in.fail("sdl.transformation", "this transformation has no inverse", open.span);
    return *inverted;
}

bool optionalFlag(Interpreter& in) {
    const Token& token = in.peek();
    const bool isFlag = token.kind == TokenKind::number || token.isWord("on") || token.isWord("off") ||
                        token.isWord("yes") || token.isWord("no") || token.isWord("true") ||
                        token.isWord("false");
    return isFlag || (token.kind == TokenKind::word && token.symbol && in.startsExpression()) ? in.flag()
                                                                                              : true;
}

/// The object whose keyword comes next; null if none comes.
ObjectPtr Parser::object(Interpreter& in) {
    const Interpreter::Nested nested(in);
    if (auto named = in.acceptNamed<ObjectPtr>()) return *named;
    if (in.peek().kind != TokenKind::word || in.peek().symbol || !isObjectKeyword(in.peek().text))
        return nullptr;
    const Token keyword = in.next();
    takeObjects(in, 1, keyword.span);
    auto made = std::make_shared<Object>();
    if (keyword.text == "object") {
        in.expect('{');
        if (ObjectPtr inner = object(in))
            *made = *inner; // with its transformation and textures, to which more may be added
        else
            in.failExpected("an object or its name");
        // The place of what is seen is where it is put, not where it was declared.
    } else {
        in.expect('{');
        // "sphere { NAME translate x }" copies, where a name is not a part.
        const bool hasParts = keyword.text == "union" || keyword.text == "merge" ||
                              keyword.text == "intersection" || keyword.text == "difference";
        if (const auto named = hasParts ? std::nullopt : in.acceptNamed<ObjectPtr>())
            *made = **named;
        else
            made->shape = shape(in, keyword);
    }
    made->span = keyword.span;
    modifiers(in, *made);
    measure(in, *made);
    return made;
}

void Parser::measure(Interpreter& in, Object& object) {
    const Limits& limits = in.environment().limits;
    object.count = 1, object.depth = 1;
    const auto take = [&](const Object& part) {
        object.count += part.count;
        object.depth = std::max(object.depth, part.depth + 1);
        if (object.depth > limits.nesting)
            in.fail("sdl.too-deep", fmt::format("more than {} levels of objects", limits.nesting),
                    object.span);
        if (object.count > limits.objects) failTooManyObjects(in, object.span);
    };
    if (const auto* all = std::get_if<UnionShape>(&object.shape))
        for (const ObjectPtr& part : all->parts) take(*part);
    if (const auto* light = std::get_if<LightShape>(&object.shape))
        if (light->looksLike) take(*light->looksLike);
    for (const auto* layers : {&object.appearance.layers, &object.appearance.backLayers})
        if (*layers && !(*layers)->empty()) takeObjects(in, (*layers)->size() - 1, object.span);
}

void Parser::takeObjects(Interpreter& in, std::size_t count, Span where) {
    if (count > in.environment().limits.objects - objects_) failTooManyObjects(in, where);
    objects_ += count;
}

ObjectShape Parser::shape(Interpreter& in, const Token& keyword) {
    const std::string_view kind = keyword.text;
    if (kind == "sphere") {
        SphereShape s{in.point()};
        in.comma();
        s.radius = in.number();
        return s;
    }
    if (kind == "box") {
        BoxShape b{in.point(), {}};
        in.comma();
        b.b = in.point();
        return b;
    }
    if (kind == "cylinder" || kind == "cone") {
        ConeShape c;
        c.a = in.point();
        in.comma();
        if (kind == "cone") c.radiusA = in.number(), in.comma();
        c.b = in.point();
        in.comma();
        c.radiusB = in.number();
        if (kind == "cylinder") c.radiusA = c.radiusB;
        c.open = in.accept("open");
        return c;
    }
    if (kind == "disc") {
        DiscShape d{in.point()};
        in.comma();
        d.normal = in.point();
        in.comma();
        d.radius = in.number();
        if (in.accept(',')) d.hole = in.number();
        return d;
    }
    if (kind == "torus") {
        TorusShape t{in.number()};
        in.comma();
        t.minor = in.number();
        return t;
    }
    if (kind == "plane") {
        PlaneShape p{in.point()};
        in.comma();
        p.distance = in.number();
        return p;
    }
    if (kind == "triangle" || kind == "smooth_triangle") {
        TriangleShape t;
        if (kind == "smooth_triangle") t.normals.emplace();
        for (std::size_t i = 0; i < 3; ++i) {
            t.corners[i] = in.point();
            in.comma();
            if (t.normals) (*t.normals)[i] = in.point(), in.comma();
        }
        return t;
    }
    if (kind == "polygon") return polygon(in);
    if (kind == "mesh") return std::make_shared<const MeshShape>(mesh(in));
    if (kind == "mesh2") return std::make_shared<const MeshShape>(mesh2(in));
    if (kind == "light_source") return light(in);
    if (kind == "union" || kind == "merge") {
        UnionShape all{{}, kind == "merge"};
        parts(in, all);
        if (all.parts.size() == 1)
            if (const auto* exact = std::get_if<ExactShape>(&all.parts.front()->shape)) return *exact;
        return all;
    }
    // YARTE has no shape for the others. Their text is run, for what it declares, and left out.
    while (!in.peek().is('}')) { // what is in it, for the names it declares
        const Token token = in.next();
        if (token.kind == TokenKind::end)
            in.fail("sdl.no-brace", fmt::format("this {} has no closing brace", kind), keyword.span);
        if (token.is('{')) in.skipBlock();
    }
    return UnsupportedShape{std::string(kind)};
}

void Parser::parts(Interpreter& in, UnionShape& all) {
    for (;;) {
        if (ObjectPtr part = object(in))
            all.parts.push_back(std::move(part));
        else if (!in.acceptNamed<Shared<OpaqueValue>>()) // by a known macro, for POV-Ray's sake
            return;
    }
}

PolygonShape Parser::polygon(Interpreter& in) {
    const Span where = in.peek().span;
    const int count = in.integer();
    if (count < 3) in.fail("sdl.polygon", "a polygon has at least 3 points", where);
    PolygonShape polygon;
    bool isOpen = false; // between contours
    for (int i = 0; i < count; ++i) {
        in.comma();
        const Vec3 p = in.point();
        if (!isOpen) {
            polygon.contours.push_back({p});
            isOpen = true;
        } else if (polygon.contours.back().front() == p) {
            isOpen = false;
        } else {
            polygon.contours.back().push_back(p);
        }
    }
    return polygon;
}

void Parser::modifiers(Interpreter& in, Object& object) {
    while (!in.accept('}'))
        if (!modifier(in, object))
            in.failExpected("a modifier of an object, such as texture or translate, or '}'");
}

bool Parser::modifier(Interpreter& in, Object& object) {
    Appearance& look = object.appearance;
    const auto plain = [&]() -> Texture& { // the texture that a bare pigment or finish changes
        look.exact.reset();
        if (!look.layers) look.layers = Layers{defaultTexture()};
        return look.layers->back();
    };
    if (in.accept(',')) return true;
    const auto turn = in.acceptNamed<Shared<Affine>>(); // by a known macro
    const bool moves = in.peek().isWord("translate");
    if (const auto transformation = turn ? std::optional(**turn) : acceptTransformation(in)) {
        object.transform = then(object.transform, *transformation);
        if (turn)
            object.exactAxes = Referential{(*turn)->x, (*turn)->y, (*turn)->z};
        else if (!moves)
            object.exactAxes.reset();
        return true;
    }
    const Token& token = in.peek();
    if (token.kind != TokenKind::word) return false;
    const std::string_view w = token.text;
    if (w == "texture") {
        in.next();
        look.exact.reset();
        putOn(in, look.layers, texture(in));
    } else if (w == "interior_texture") {
        in.next();
        look.exact.reset();
        putOn(in, look.backLayers, texture(in));
    } else if (w == "pigment") {
        in.next();
        pigment(in, plain().pigment);
    } else if (w == "finish") {
        in.next();
        finish(in, plain().finish);
    } else if (w == "normal") {
        in.next();
        in.skipBraces();
        plain().hasNormal = true;
    } else if (w == "interior") {
        in.next();
        look.exact.reset();
        look.interior = look.interior.value_or(Interior{});
        interior(in, *look.interior);
    } else if (w == "material") {
        in.next();
        Appearance made;
        material(in, made);
        if (made.layers) putOn(in, look.layers, std::move(*made.layers));
        if (made.backLayers) putOn(in, look.backLayers, std::move(*made.backLayers));
        if (made.interior) look.interior = std::move(made.interior);
        look.exact = made.exact;
    } else if (w == "color" || w == "colour") { // old files: of a quick preview
        plain().pigment = {in.colour()};
    } else if (w == "clipped_by" || w == "bounded_by" || w == "photons" || w == "radiosity") {
        const bool isClip = in.next().text == "clipped_by";
        if (isClip) object.ignored.emplace_back("clipped_by");
        in.skipBraces();
    } else if (w == "no_shadow" || w == "no_reflection" || w == "double_illuminate" || w == "no_image" ||
               w == "inverse") {
        const std::string word(in.next().text);
        if (!optionalFlag(in)) return true;
        object.isHidden |= word == "no_image";
        if (word != "inverse" || !std::holds_alternative<ExactShape>(object.shape))
            object.ignored.push_back(word);
    } else if (w == "open") {
        in.next();
        const bool isOpen = optionalFlag(in);
        if (auto* cone = std::get_if<ConeShape>(&object.shape)) cone->open = isOpen;
    } else if (w == "hollow" || w == "sturm" || w == "hierarchy" || w == "split_union" ||
               w == "no_radiosity" || w == "uv_mapping" || w == "cutaway_textures" || w == "water_level" ||
               w == "smooth" || w == "collect" || w == "pass_through") {
        in.next();
        optionalFlag(in);
    } else if (w == "uv_vectors") {
        in.next();
        while (in.startsExpression()) in.expression(), in.comma();
    } else if (w == "inside_vector") {
        in.next();
        in.vector3();
    } else {
        return false;
    }
    return true;
}

} // namespace yarte::convert::povray::sdl
