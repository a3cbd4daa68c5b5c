// Vec3: a point or a direction in three dimensions, double precision.
#pragma once

#include <algorithm>
#include <cmath>

namespace yarte {

struct Vec3 {
    double x = 0, y = 0, z = 0;

    friend constexpr bool operator==(const Vec3&, const Vec3&) = default;

    constexpr Vec3& operator+=(Vec3 v) { return *this = {x + v.x, y + v.y, z + v.z}; }
};

constexpr Vec3 operator+(Vec3 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
constexpr Vec3 operator-(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
constexpr Vec3 operator-(Vec3 a) { return {-a.x, -a.y, -a.z}; }
constexpr Vec3 operator*(Vec3 a, double s) { return {a.x * s, a.y * s, a.z * s}; }
constexpr Vec3 operator*(double s, Vec3 a) { return a * s; }
constexpr Vec3 operator/(Vec3 a, double s) { return {a.x / s, a.y / s, a.z / s}; }

constexpr double dot(Vec3 a, Vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
constexpr Vec3 cross(Vec3 a, Vec3 b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double length(Vec3 a) { return std::sqrt(dot(a, a)); }

/// The unit vector along `a`, which must have a length that neither overflows nor is 0.
inline Vec3 normalised(Vec3 a) { return a / length(a); }

/// The unit vector along `a`, which may be of any length but 0: its largest component is divided out first,
/// so that no square overflows.
inline Vec3 unitVector(Vec3 a) {
    return normalised(a / std::max({std::abs(a.x), std::abs(a.y), std::abs(a.z)}));
}

inline bool isFinite(Vec3 a) { return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z); }

} // namespace yarte
