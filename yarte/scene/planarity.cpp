#include "yarte/scene/planarity.h"

#include <algorithm>
#include <cmath>

namespace yarte {

std::optional<Planarity> planarity(std::span<const Vec3> vertices) {
    if (vertices.size() < 3) return std::nullopt;
    // In units of the largest coordinate, so that no square overflows or vanishes.
    double unit = 0;
    for (const Vec3 v : vertices) unit = std::max({unit, std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    if (unit == 0) return std::nullopt;
    const auto count = static_cast<double>(vertices.size());
    Vec3 mean;
    for (const Vec3 v : vertices) mean += v / unit / count;
    double radius = 0;
    for (const Vec3 v : vertices) radius = std::max(radius, length(v / unit - mean));
    if (radius == 0) return std::nullopt;

    const auto local = [&](std::size_t i) { return (vertices[i] / unit - mean) / (2 * radius); };
    Vec3 normal; // its length is twice the area
    for (std::size_t i = 0; i < vertices.size(); ++i)
        normal += cross(local(i), local(i + 1 < vertices.size() ? i + 1 : 0));
    if (length(normal) <= 2 * minRelativeArea) return std::nullopt;

    Planarity worst;
    for (std::size_t i = 0; i < vertices.size(); ++i)
        if (const double error = std::abs(dot(local(i), normalised(normal))); error > worst.error)
            worst = {error, i};
    return worst;
}

} // namespace yarte
