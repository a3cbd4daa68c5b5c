#include "yarte/scene/referential.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace yarte {
namespace {

double angleBetween(Vec3 a, Vec3 b) { return std::atan2(length(cross(a, b)), dot(a, b)); }

} // namespace

std::optional<std::string> referentialError(const Referential& r) {
    if (r.x == Vec3{} || r.y == Vec3{}) return "an axis of length 0 has no direction";
    const Vec3 x = unitVector(r.x), y = unitVector(r.y);
    const auto offSquare = [](const char* name, Vec3 a, Vec3 b) -> std::optional<std::string> {
        const double angle = angleBetween(a, b);
        if (std::abs(angle - std::numbers::pi / 2) <= maxAxisError) return std::nullopt;
        return fmt::format("axes {} are not perpendicular: the angle between them is {:.6g} degrees", name,
                           angle * 180 / std::numbers::pi);
    };
    if (auto error = offSquare("x and y", x, y)) return error;
    if (!r.z || *r.z == Vec3{}) return std::nullopt;
    const Vec3 z = unitVector(*r.z);
    if (auto error = offSquare("x and z", x, z)) return error;
    if (auto error = offSquare("y and z", y, z)) return error;
    if (dot(cross(x, y), z) < 0)
        return fmt::format("axes are left-handed: z is at {:.6g} degrees from x cross y",
                           angleBetween(cross(x, y), z) * 180 / std::numbers::pi);
    return std::nullopt;
}

Frame resolveReferential(const Referential& r) {
    const Twofold3 x = preciseUnitVector(r.x), y = preciseUnitVector(r.y);
    const bool hasZ = r.z && *r.z != Vec3{};
    return closestRotation(x, y, hasZ ? preciseUnitVector(*r.z) : normalised(cross(x, y)));
}

} // namespace yarte
