#include "yarte/scene/referential.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace yarte {
namespace {

struct Versors {
    Vec3 x, y, z;
};

/// Scaled first by the largest component, so that any finite vector can be normalised.
Vec3 versor(Vec3 v) {
    const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    return normalised(v / largest);
}

Versors versors(const Referential& r) {
    const Vec3 x = versor(r.x), y = versor(r.y);
    const bool hasZ = r.z && *r.z != Vec3{};
    return {x, y, hasZ ? versor(*r.z) : normalised(cross(x, y))};
}

double angleBetween(Vec3 a, Vec3 b) { return std::atan2(length(cross(a, b)), dot(a, b)); }

} // namespace

std::optional<std::string> referentialError(const Referential& r) {
    if (r.x == Vec3{} || r.y == Vec3{}) return "an axis of length 0 has no direction";
    const Vec3 x = versor(r.x), y = versor(r.y);
    const auto offSquare = [](const char* name, Vec3 a, Vec3 b) -> std::optional<std::string> {
        const double angle = angleBetween(a, b);
        if (std::abs(angle - std::numbers::pi / 2) <= maxAxisError) return std::nullopt;
        return fmt::format("axes {} are not perpendicular: the angle between them is {:.6g} degrees", name,
                           angle * 180 / std::numbers::pi);
    };
    if (auto error = offSquare("x and y", x, y)) return error;
    if (!r.z || *r.z == Vec3{}) return std::nullopt;
    const Vec3 z = versor(*r.z);
    if (auto error = offSquare("x and z", x, z)) return error;
    if (auto error = offSquare("y and z", y, z)) return error;
    if (dot(cross(x, y), z) < 0)
        return fmt::format("axes are left-handed: z is at {:.6g} degrees from x cross y",
                           angleBetween(cross(x, y), z) * 180 / std::numbers::pi);
    return std::nullopt;
}

Frame resolveReferential(const Referential& r) {
    const auto [x, y, z] = versors(r);
    return closestRotation(x, y, z);
}

} // namespace yarte
