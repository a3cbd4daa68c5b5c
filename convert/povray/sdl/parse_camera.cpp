// Cameras. From version 3.5 on the order of the words does not matter: vectors come first, then angle, then
// look_at, then transformations. Before that each word acts on what those before it have made.

#include "convert/povray/sdl/parser.h"

#include <cmath>
#include <numbers>

namespace yarte::convert::povray::sdl {
namespace {

constexpr std::string_view kinds[] = {"perspective",      "orthographic", "fisheye",
                                      "ultra_wide_angle", "omnimax",      "panoramic",
                                      "spherical",        "cylinder",     "mesh_camera"};

bool isKind(std::string_view word) {
    for (const std::string_view kind : kinds)
        if (word == kind) return true;
    return false;
}

/// Moves the picture's plane to where its width is seen under `angle` degrees.
void open(CameraModel& camera, double angle) {
    const double distance = length(camera.right) / 2 / std::tan(angle * std::numbers::pi / 360);
    camera.direction = camera.direction * (distance / length(camera.direction));
}

/// Turns the camera to `target`, with `sky` above; lengths and handedness stay.
void aim(CameraModel& camera, Vec3 target, Vec3 sky) {
    const double direction = length(camera.direction), right = length(camera.right), up = length(camera.up);
    const bool isLeftHanded = dot(cross(camera.up, camera.direction), camera.right) > 0;
    const Vec3 f = normalised(target - camera.location);
    Vec3 r = cross(sky, f);
    // Along the sky POV-Ray takes the right there is, even where that is not perpendicular.
    r = normalised(length(r) < 1e-10 * length(sky) ? camera.right : r);
    camera.direction = f * direction;
    camera.right = r * (isLeftHanded ? right : -right);
    camera.up = cross(f, r) * up;
}

/// Makes an orthographic picture as large as a perspective one is at `target`.
void fit(CameraModel& camera, Vec3 target) {
    const double scale = length(target - camera.location) / length(camera.direction);
    camera.right = camera.right * scale, camera.up = camera.up * scale;
}

void move(CameraModel& camera, const Affine& by) {
    camera.location = mapPoint(by, camera.location);
    camera.direction = mapDirection(by, camera.direction);
    camera.right = mapDirection(by, camera.right);
    camera.up = mapDirection(by, camera.up);
}

} // namespace

/// The opening brace comes next.
CameraModel Parser::camera(Interpreter& in, Span span) {
    const Interpreter::Nested nested(in);
    const bool inSequence = in.languageVersion() < 3.5;
    in.expect('{');
    CameraModel camera;
    Vec3 sky{0, 1, 0};
    std::optional<double> angle;
    std::optional<Vec3> target;
    const Vec3 defaultTarget{0, 0, 1};
    bool hasSize = false;
    Affine moved;
    while (!in.accept('}')) {
        const Token& token = in.peek();
        if (auto named = in.acceptNamed<Shared<CameraModel>>()) {
            camera = **named;
            hasSize = true; // it has been fitted
            continue;
        }
        if (const auto transformation = acceptTransformation(in)) {
            if (inSequence)
                move(camera, *transformation);
            else
                moved = then(moved, *transformation);
            continue;
        }
        if (token.kind != TokenKind::word) in.failExpected("a word of camera, such as location");
        const Token word = in.next();
        if (isKind(word.text)) {
            camera.kind = word.text;
            if (word.text == "cylinder") in.number();
            if (word.text == "mesh_camera") in.skipBraces();
            if (word.text == "orthographic" && inSequence) fit(camera, target.value_or(defaultTarget));
        } else if (word.text == "location") {
            camera.location = in.vector3();
        } else if (word.text == "direction") {
            camera.direction = in.vector3();
        } else if (word.text == "right") {
            camera.right = in.vector3();
            hasSize = true;
        } else if (word.text == "up") {
            camera.up = in.vector3();
            hasSize = true;
        } else if (word.text == "sky") {
            sky = in.vector3();
        } else if (word.text == "look_at") {
            target = in.vector3();
            if (inSequence && *target != camera.location) aim(camera, *target, sky);
        } else if (word.text == "angle") {
            const Span where = in.peek().span;
            angle = in.number();
            if (!(*angle > 0 && *angle <= 360))
                in.fail("sdl.angle", "the angle must be between 0 and 360", where);
            if (in.accept(',')) in.number();
            if (inSequence && *angle < 180 && camera.kind != "orthographic") open(camera, *angle);
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
    if (!inSequence) {
        if (angle && *angle < 180) open(camera, *angle);
        if (target && *target == camera.location)
            in.fail("sdl.look-at", "the camera's look_at is its location", span);
        if (camera.kind == "orthographic" && (angle || !hasSize)) fit(camera, target.value_or(defaultTarget));
        if (target) aim(camera, *target, sky);
        move(camera, moved);
    }
    camera.span = span;
    return camera;
}

} // namespace yarte::convert::povray::sdl
