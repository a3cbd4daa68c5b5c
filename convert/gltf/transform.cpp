#include "convert/gltf/transform.h"

#include <algorithm>
#include <cmath>

namespace yarte::convert::gltf {

Transform fromParts(Vec3 translation, std::array<double, 4> rotation, Vec3 scale) {
    const double norm = std::sqrt(rotation[0] * rotation[0] + rotation[1] * rotation[1] +
                                  rotation[2] * rotation[2] + rotation[3] * rotation[3]);
    const double x = rotation[0] / norm, y = rotation[1] / norm, z = rotation[2] / norm,
                 w = rotation[3] / norm;
    return {Vec3{1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w)} * scale.x,
            Vec3{2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w)} * scale.y,
            Vec3{2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y)} * scale.z, translation};
}

Transform normalTransform(const Transform& m) {
    const double sign = m.determinant() < 0 ? -1 : 1;
    return {cross(m.y, m.z) * sign, cross(m.z, m.x) * sign, cross(m.x, m.y) * sign, {}};
}

std::optional<Similarity> asSimilarity(const Transform& m) {
    const double lx = length(m.x), ly = length(m.y), lz = length(m.z);
    const double scale = lx;
    if (!(scale > 0) || !std::isfinite(scale) || m.determinant() <= 0) return std::nullopt;
    if (std::max(std::abs(ly - lx), std::abs(lz - lx)) > similarityTolerance * scale) return std::nullopt;
    const Vec3 x = m.x / lx, y = m.y / ly, z = m.z / lz;
    if (std::max({std::abs(dot(x, y)), std::abs(dot(y, z)), std::abs(dot(z, x))}) > similarityTolerance)
        return std::nullopt;
    return Similarity{scale, {x, y, z}, m.translation};
}

} // namespace yarte::convert::gltf
