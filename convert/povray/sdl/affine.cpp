#include "convert/povray/sdl/affine.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace yarte::convert::povray::sdl {
namespace {

bool isLinearIdentity(const Affine& a) {
    return a.x == Vec3{1, 0, 0} && a.y == Vec3{0, 1, 0} && a.z == Vec3{0, 0, 1};
}

/// Adding 0 changes no bit: of two zeros the sum is -0 if one of them is.
double sum(double a, double b) {
    if (a == 0 && b == 0) return std::signbit(a) ? a : b;
    return a + b;
}

Vec3 sum(Vec3 a, Vec3 b) { return {sum(a.x, b.x), sum(a.y, b.y), sum(a.z, b.z)}; }

double largest(Vec3 v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

/// Of its linear part: products of three numbers neither overflow nor vanish after division by it.
double unitOf(const Affine& a) {
    int exponent = 0;
    std::frexp(std::max({largest(a.x), largest(a.y), largest(a.z)}), &exponent);
    return std::ldexp(1.0, std::clamp(exponent, -1000, 1000));
}

/// Quarter turns are exact.
double sine(double degrees) {
    const double turn = std::remainder(degrees, 360.0);
    if (turn == 0 || std::abs(turn) == 180) return 0;
    if (std::abs(turn) == 90) return turn > 0 ? 1 : -1;
    return std::sin(turn * std::numbers::pi / 180);
}

double cosine(double degrees) {
    const double turn = std::abs(std::remainder(degrees, 360.0));
    if (turn == 90) return 0;
    return turn == 180 ? -1 : std::cos(turn * std::numbers::pi / 180);
}

} // namespace

Vec3 mapDirection(const Affine& a, Vec3 d) {
    if (isLinearIdentity(a) || d == Vec3{}) return d;
    return a.x * d.x + a.y * d.y + a.z * d.z;
}

Vec3 mapPoint(const Affine& a, Vec3 p) { return sum(mapDirection(a, p), a.t); }

Vec3 mapNormal(const Affine& a, Vec3 n) {
    if (isLinearIdentity(a)) return n;
    const double unit = unitOf(a);
    const Vec3 x = a.x / unit, y = a.y / unit, z = a.z / unit;
    const Vec3 mapped = cross(y, z) * n.x + cross(z, x) * n.y + cross(x, y) * n.z;
    return dot(x, cross(y, z)) < 0 ? -mapped : mapped;
}

double determinant(const Affine& a) { return dot(a.x, cross(a.y, a.z)); }

Affine then(const Affine& a, const Affine& b) {
    if (isLinearIdentity(a) && a.t == Vec3{}) return b;
    Affine both = isLinearIdentity(a) ? b
                  : isLinearIdentity(b)
                      ? a
                      : Affine{mapDirection(b, a.x), mapDirection(b, a.y), mapDirection(b, a.z), {}};
    both.t = mapPoint(b, a.t);
    return both;
}

std::optional<Affine> inverse(const Affine& a) {
    const double unit = unitOf(a);
    const Vec3 x = a.x / unit, y = a.y / unit, z = a.z / unit;
    const double det = dot(x, cross(y, z));
    if (det == 0 || !std::isfinite(det)) return std::nullopt;
    // The columns of the inverse are the cross products of the rows.
    const Vec3 c = cross(y, z) / det / unit, d = cross(z, x) / det / unit, e = cross(x, y) / det / unit;
    Affine result{{c.x, d.x, e.x}, {c.y, d.y, e.y}, {c.z, d.z, e.z}, {}};
    result.t = mapDirection(result, -a.t);
    const bool isGood = isFinite(result.x) && isFinite(result.y) && isFinite(result.z) && isFinite(result.t);
    return isGood ? std::optional(result) : std::nullopt;
}

Affine translation(Vec3 by) { return {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, by}; }

Affine scaling(Vec3 by) {
    const auto factor = [](double f) { return f == 0 ? 1 : f; };
    return {{factor(by.x), 0, 0}, {0, factor(by.y), 0}, {0, 0, factor(by.z)}, {}};
}

Affine rotation(Vec3 degrees) {
    const auto about = [](double angle, Affine (*make)(double, double)) {
        return angle == 0 ? Affine{} : make(cosine(angle), sine(angle));
    };
    const Affine x = about(degrees.x, [](double c, double s) {
        return Affine{{1, 0, 0}, {0, c, s}, {0, -s, c}, {}};
    });
    const Affine y = about(degrees.y, [](double c, double s) {
        return Affine{{c, 0, -s}, {0, 1, 0}, {s, 0, c}, {}};
    });
    const Affine z = about(degrees.z, [](double c, double s) {
        return Affine{{c, s, 0}, {-s, c, 0}, {0, 0, 1}, {}};
    });
    return then(then(x, y), z);
}

Affine axisRotation(Vec3 axis, double degrees) {
    const double size = largest(axis);
    if (degrees == 0 || size == 0 || !std::isfinite(size)) return {};
    const Vec3 k = normalised(axis / size);
    const double c = cosine(degrees), s = sine(degrees);
    // [Rodrigues]: v cos + (k x v) sin + k (k.v)(1 - cos)
    const auto turned = [&](Vec3 v) { return v * c + cross(k, v) * s + k * (dot(k, v) * (1 - c)); };
    return {turned({1, 0, 0}), turned({0, 1, 0}), turned({0, 0, 1}), {}};
}

} // namespace yarte::convert::povray::sdl
