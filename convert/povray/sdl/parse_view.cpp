// Cameras, lights, settings.

#include "convert/povray/sdl/parser.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace yarte::convert::povray::sdl {
namespace {

constexpr std::string_view cameraKinds[] = {"perspective",      "orthographic", "fisheye",
                                            "ultra_wide_angle", "omnimax",      "panoramic",
                                            "spherical",        "cylinder",     "mesh_camera"};

} // namespace

/// The opening brace comes next. What is written is taken in POV-Ray's order: vectors, then angle, then
/// look_at, then transformations.
CameraModel Parser::camera(Interpreter& in, Span span) {
    const Interpreter::Nested nested(in);
    in.expect('{');
    CameraModel camera;
    Vec3 sky{0, 1, 0};
    std::optional<double> angle;
    std::optional<Vec3> target;
    Affine moved;
    while (!in.accept('}')) {
        const Token& token = in.peek();
        if (auto named = in.acceptNamed<Shared<CameraModel>>()) {
            camera = **named;
            continue;
        }
        if (const auto transformation = acceptTransformation(in)) {
            moved = then(moved, *transformation);
            continue;
        }
        if (token.kind != TokenKind::word) in.failExpected("a word of camera, such as location");
        const Token word = in.next();
        bool isKind = false;
        for (const std::string_view kind : cameraKinds) isKind |= word.text == kind;
        if (isKind) {
            camera.kind = word.text;
            if (word.text == "cylinder") in.number();
            if (word.text == "mesh_camera") in.skipBraces();
        } else if (word.text == "location") {
            camera.location = in.vector3();
        } else if (word.text == "direction") {
            camera.direction = in.vector3();
        } else if (word.text == "right") {
            camera.right = in.vector3();
        } else if (word.text == "up") {
            camera.up = in.vector3();
        } else if (word.text == "sky") {
            sky = in.vector3();
        } else if (word.text == "look_at") {
            target = in.vector3();
        } else if (word.text == "angle") {
            const Span where = in.peek().span;
            angle = in.number();
            if (!(*angle > 0 && *angle <= 360))
                in.fail("sdl.angle", "the angle must be between 0 and 360", where);
            if (in.accept(',')) in.number();
        } else if (word.text == "aperture" || word.text == "normal") {
            camera.ignored.emplace_back(word.text);
            if (in.accept('{'))
                in.skipBlock();
            else
                in.number();
        } else if (word.text == "focal_point") {
            in.vector3();
        } else if (word.text == "blur_samples") {
            in.number();
            if (in.accept(',')) in.number();
        } else if (in.peek().is('{')) {
            in.next();
            in.skipBlock();
        } else if (in.startsExpression()) {
            in.expression(); // confidence, variance, smooth, ...
            while (in.accept(',')) in.expression();
        }
    }
    if (angle && camera.kind == "perspective" && *angle < 180)
        camera.direction =
            camera.direction *
            (length(camera.right) / 2 / std::tan(*angle * std::numbers::pi / 360) / length(camera.direction));
    if (target) {
        const double direction = length(camera.direction), right = length(camera.right),
                     up = length(camera.up);
        const double side = dot(cross(camera.up, camera.direction), camera.right); // > 0: left-handed
        const Vec3 forward = *target - camera.location;
        if (length(forward) > 0) {
            const Vec3 f = forward / length(forward);
            Vec3 r = cross(sky, f);
            if (length(r) < 1e-10 * length(sky)) { // looking along the sky: any that is not
                sky = std::abs(f.y) > 0.5 ? Vec3{0, 0, 1} : Vec3{0, 1, 0};
                r = cross(sky, f);
            }
            r = r / length(r);
            camera.direction = f * direction;
            camera.right = r * (side > 0 ? right : -right);
            camera.up = cross(f, r) * up;
        }
    }
    camera.location = mapPoint(moved, camera.location);
    camera.direction = mapDirection(moved, camera.direction);
    camera.right = mapDirection(moved, camera.right);
    camera.up = mapDirection(moved, camera.up);
    camera.span = span;
    return camera;
}

LightShape Parser::light(Interpreter& in, Object& object) {
    LightShape light;
    light.position = in.point();
    in.comma();
    const Rgbft c = in.colour();
    light.colour = {c.r, c.g, c.b};
    while (!in.peek().is('}')) {
        if (const auto transformation = acceptTransformation(in)) {
            object.transform = then(object.transform, *transformation);
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
            if (w == "area_light") {
                in.vector3(), in.comma(), in.vector3(), in.comma(), in.number(), in.comma(), in.number();
            } else if (w == "projected_through") {
                in.skipBraces();
            } else if (w == "fade_distance" || w == "fade_power") {
                in.number();
            }
        } else if (w == "point_at") {
            in.vector3();
        } else if (w == "media_attenuation" || w == "media_interaction" || w == "area_illumination") {
            optionalFlag(in);
        } else if (in.accept('{')) {
            in.skipBlock();
        } else if (w != "jitter" && w != "circular" && w != "orient" && in.startsExpression()) {
            in.expression();
        }
    }
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
