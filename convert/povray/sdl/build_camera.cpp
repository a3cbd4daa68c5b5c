#include "convert/povray/sdl/build_camera.h"

#include "convert/povray/sdl/body_extent.h"
#include "convert/povray/sdl/stretch.h"
#include "yarte/base/number.h"
#include "yarte/scene/check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace yarte::convert::povray::sdl {
namespace {

double degrees(double radians) { return radians * 180 / std::numbers::pi; }

/// In units of the reach of the bodies: an orthographic camera's parallel rays part by less than its inverse.
constexpr double farAway = 1000;

/// Angle by which two unit vectors are off perpendicular, in degrees.
double offSquare(Vec3 a, Vec3 b) { return degrees(std::abs(std::asin(std::clamp(dot(a, b), -1.0, 1.0)))); }

class CameraBuilder {
public:
    CameraBuilder(const CameraModel& model, const Affine& world, const Scene& bodies, Report& report)
        : model_(model), bodies_(bodies), report_(report), location_(mapPoint(world, model.location)),
          direction_(mapDirection(world, model.direction)), right_(mapDirection(world, model.right)),
          up_(mapDirection(world, model.up)) {}

    Camera build() {
        Camera camera = model_.kind == "orthographic" ? orthographic() : perspective();
        camera.up = up_;
        const double r = offSquare(unit(right_), unit(direction_)),
                     u = offSquare(unit(up_), unit(direction_)), s = offSquare(unit(right_), unit(up_));
        if (const double off = std::max({r, u, s}); off > 1e-6)
            tell("right and up", "as if perpendicular to the direction and one another; in degrees", off);
        if (model_.kind != "perspective" && model_.kind != "orthographic")
            tell("kind", model_.kind + " becomes perspective", {});
        for (const std::string& word : model_.ignored)
            report_.tell("camera", model_.span, {word, Action::dropped, "has no counterpart"});
        return camera;
    }

private:
    void tell(const char* property, std::string detail, std::optional<double> bound) {
        report_.tell("camera", model_.span, {property, Action::approximated, std::move(detail), bound});
    }

    /// `distance`: to a plane where the picture's sides are |right| and |up|.
    Camera seen(Vec3 position, Vec3 focus, double distance) const {
        Camera camera;
        camera.position = position, camera.focus = focus;
        camera.horizontalApertureDegrees = degrees(std::atan(lengthOf(right_) / 2 / distance));
        camera.verticalApertureDegrees = degrees(std::atan(lengthOf(up_) / 2 / distance));
        return camera;
    }

    Camera perspective() const { return seen(location_, location_ + direction_, lengthOf(direction_)); }

    /// From so far away that the rays are nearly parallel, exact in size in the middle of what is seen.
    Camera orthographic() {
        const Vec3 along = unit(direction_);
        const Reach reach = reachOf(bodies_, location_, along);
        const double size = std::max({reach.distance, lengthOf(right_), lengthOf(up_)});
        const double middle = std::max(0.0, (reach.nearest + reach.farthest) / 2), distance = farAway * size;
        const double depth = std::max(reach.farthest - middle, middle);
        tell("orthographic",
             fmt::format("a perspective one {} away; sizes in the picture, relative", printNumber(distance)),
             depth / (distance - depth));
        if (reach.nearest < 0 || reach.hasPlane)
            tell("orthographic", "what lies behind the camera's plane is seen too", {});
        return seen(location_ + along * (middle - distance), location_ + along * middle, distance);
    }

    const CameraModel& model_;
    const Scene& bodies_;
    Report& report_;
    Vec3 location_, direction_, right_, up_;
};

} // namespace

bool isLeftHanded(const CameraModel& camera) {
    return !camera.exact && dot(camera.right, cross(camera.direction, camera.up)) < 0;
}

std::optional<Camera> buildCamera(const CameraModel& model, const Affine& world, const Scene& bodies,
                                  Report& report, Diagnostics& diagnostics) {
    if (model.exact) return model.exact;
    const auto isBad = [](Vec3 v) { return v == Vec3{} || !isFinite(v); };
    if (isBad(model.direction) || isBad(model.right) || isBad(model.up) || !isFinite(model.location)) {
        diagnostics.error("sdl.bad-camera", "a camera's direction, right and up must be finite and not 0",
                          model.span);
        return std::nullopt;
    }
    const Camera camera = CameraBuilder(model, world, bodies, report).build();
    Problems problems = check(camera);
    for (Problem& problem : checkApertures(camera.horizontalApertureDegrees, camera.verticalApertureDegrees))
        problems.push_back(std::move(problem));
    for (const Problem& problem : problems) diagnostics.error(problem.code, problem.message, model.span);
    return problems.empty() ? std::optional(camera) : std::nullopt;
}

} // namespace yarte::convert::povray::sdl
