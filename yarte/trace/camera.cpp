#include "yarte/trace/camera.h"

#include <cmath>
#include <numbers>

namespace yarte::trace {

CameraRays::CameraRays(const Camera& camera, Resolution resolution)
    : position(camera.position), width(resolution.width), height(resolution.height) {
    const auto tangent = [](double degrees) { return std::tan(degrees * (std::numbers::pi / 180)); };
    forward = normalised(camera.focus - camera.position);
    const Vec3 unitRight = normalised(cross(forward, camera.up));
    right = unitRight * (2 * tangent(camera.horizontalApertureDegrees));
    up = cross(unitRight, forward) * (2 * tangent(camera.verticalApertureDegrees));
}

} // namespace yarte::trace
