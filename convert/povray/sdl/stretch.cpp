#include "convert/povray/sdl/stretch.h"

#include <algorithm>
#include <cmath>

namespace yarte::convert::povray::sdl {

double lengthOf(Vec3 v) { return std::hypot(v.x, v.y, v.z); }

Vec3 unit(Vec3 v) {
    const Vec3 scaled = v / std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    return scaled / lengthOf(scaled);
}

Vec3 perpendicular(Vec3 d) {
    const Vec3 size{std::abs(d.x), std::abs(d.y), std::abs(d.z)};
    if (size.x <= size.y && size.x <= size.z) return unit(Vec3{1, 0, 0} - d * d.x);
    if (size.z <= size.y) return unit(Vec3{0, 0, 1} - d * d.z);
    return unit(Vec3{0, 1, 0} - d * d.y);
}

Similarity similarityOf(const Affine& a) {
    const double x = lengthOf(a.x), y = lengthOf(a.y), z = lengthOf(a.z);
    const double scale = x == y && y == z ? x : std::hypot(x, y, z) / std::sqrt(3.0);
    if (!(scale > 0) || !std::isfinite(scale)) return {scale, 1};
    const Vec3 u = a.x / scale, v = a.y / scale, w = a.z / scale;
    // The singular values' squares are the eigenvalues of this matrix, which for a similarity is the
    // identity.
    const double diagonal = std::hypot(dot(u, u) - 1, dot(v, v) - 1, dot(w, w) - 1);
    const double rest = std::hypot(dot(u, v), dot(v, w), dot(w, u)) * std::sqrt(2.0);
    return {scale, std::hypot(diagonal, rest)};
}

double largestStretch(const Affine& a) {
    const Similarity similarity = similarityOf(a);
    if (similarity.error <= rounding) return similarity.scale;
    const double unitLength = std::max({lengthOf(a.x), lengthOf(a.y), lengthOf(a.z)});
    if (!(unitLength > 0) || !std::isfinite(unitLength)) return unitLength;
    const Vec3 x = a.x / unitLength, y = a.y / unitLength, z = a.z / unitLength;
    // The trace of the eighth power of M = A A^T bounds its largest eigenvalue from above, by at most
    // 3^(1/8).
    Vec3 r[3] = {{dot(x, x), dot(x, y), dot(x, z)},
                 {dot(y, x), dot(y, y), dot(y, z)},
                 {dot(z, x), dot(z, y), dot(z, z)}};
    for (int square = 0; square < 3; ++square) {
        Vec3 s[3];
        for (int i = 0; i < 3; ++i) s[i] = {dot(r[i], r[0]), dot(r[i], r[1]), dot(r[i], r[2])}; // symmetric
        std::copy(s, s + 3, r);
    }
    return unitLength * std::pow(r[0].x + r[1].y + r[2].z, 1.0 / 16);
}

std::optional<Referential> axesAlong(Vec3 axis) {
    if (axis == Vec3{0, 1, 0}) return std::nullopt;
    return Referential{perpendicular(axis), axis, {}};
}

} // namespace yarte::convert::povray::sdl
