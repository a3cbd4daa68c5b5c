#include "convert/tessellate.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <utility>

namespace yarte::convert {
namespace {

/// The half-angle at the centre of a chord whose middle is at most `chordError` from its circle.
double halfAngle(double radius, double chordError) {
    return std::acos(1 - std::clamp(chordError / radius, leastRelativeChordError, 1.0));
}

/// Of a circle: a multiple of four, so that the extremes along the axes are met, and never coarser than looks
/// round.
std::uint32_t segmentsOf(double radius, double chordError) {
    constexpr double least = 12;
    const double wanted = std::max(least, std::ceil(std::numbers::pi / halfAngle(radius, chordError)));
    return 4 * static_cast<std::uint32_t>(std::ceil(wanted / 4));
}

/// Unit vectors along a circle in the plane y = 0, clockwise seen from +y.
Vec3 onCircle(double part) {
    const double angle = 2 * std::numbers::pi * part;
    return {std::cos(angle), 0, std::sin(angle)};
}

/// An octahedron whose faces are cut into n^2 triangles each and blown up. A point of the grid has whole
/// coordinates i, j, k with |i| + |j| + |k| = n; their sines (a quarter turn is n) spread the points more
/// evenly over the sphere than they themselves would.
class SphereGrid {
public:
    SphereGrid(double radius, int n) : radius_(radius), n_(n) {
        for (const int x : {1, -1})
            for (const int y : {1, -1})
                for (const int z : {1, -1}) addOctant(x, y, z);
    }

    Tessellation result() && { return std::move(result_); }

private:
    void addOctant(int x, int y, int z) {
        const bool mirrored = x * y * z < 0;
        const auto at = [&](int i, int j) { return vertex({x * i, y * j, z * (n_ - i - j)}); };
        const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
            if (mirrored) std::swap(b, c);
            result_.triangles.push_back({a, b, c});
        };
        for (int i = 0; i < n_; ++i)
            for (int j = 0; i + j < n_; ++j) {
                add(at(i, j), at(i + 1, j), at(i, j + 1));
                if (i + j + 1 < n_) add(at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
            }
    }

    std::uint32_t vertex(std::array<int, 3> grid) {
        const auto [entry, isNew] =
            known_.try_emplace(grid, static_cast<std::uint32_t>(result_.positions.size()));
        if (isNew) {
            const auto sine = [&](int i) { return std::sin(std::numbers::pi / 2 * i / n_); };
            const Vec3 unit = normalised({sine(grid[0]), sine(grid[1]), sine(grid[2])});
            result_.positions.push_back(rounded(unit * radius_));
            result_.normals.push_back(rounded(unit));
        }
        return entry->second;
    }

    double radius_;
    int n_;
    Tessellation result_;
    std::map<std::array<int, 3>, std::uint32_t> known_;
};

/// Vertices lie on the sphere but for rounding; of a triangle the foot of the perpendicular from the centre
/// is farthest inside.
double sphereDeviation(const Tessellation& t, double radius) {
    double worst = 0;
    for (const Vec3f& p : t.positions) worst = std::max(worst, std::abs(length(widened(p)) - radius));
    for (const auto& [a, b, c] : t.triangles) {
        const Vec3 p = widened(t.positions[a]);
        const Vec3 across = cross(widened(t.positions[b]) - p, widened(t.positions[c]) - p);
        if (across != Vec3{}) worst = std::max(worst, radius - std::abs(dot(normalised(across), p)));
    }
    return worst;
}

/// `count` vertices from `first` on lie around the y axis; of chords between them the middles are farthest
/// inside.
double ringDeviation(const Tessellation& t, std::uint32_t first, std::uint32_t count, double radius) {
    const auto fromAxis = [](Vec3 p) { return std::hypot(p.x, p.z); };
    double worst = 0;
    for (std::uint32_t i = 0; i < count; ++i) {
        const Vec3 a = widened(t.positions[first + i]), b = widened(t.positions[first + (i + 1) % count]);
        worst = std::max({worst, std::abs(radius - fromAxis(a)), std::abs(radius - fromAxis((a + b) / 2))});
    }
    return worst;
}

class RoundBuilder {
public:
    explicit RoundBuilder(std::uint32_t segments) : segments_(segments) {}

    /// Wall between circles at the heights -h and h.
    void wall(double bottom, double top, double h) {
        const double lean = std::atan2(bottom - top, 2 * h); // of the normals, towards +y
        const auto normal = [&](Vec3 outwards) {
            return outwards * std::cos(lean) + Vec3{0, std::sin(lean), 0};
        };
        for (std::uint32_t i = 0; i < segments_; ++i) push(at(i) * bottom + Vec3{0, -h, 0}, normal(at(i)));
        // An apex has one vertex for each segment, with the normal of its middle.
        for (std::uint32_t i = 0; i < segments_; ++i)
            push(at(i) * top + Vec3{0, h, 0}, normal(top > 0 ? at(i) : at(i + 0.5)));
        for (std::uint32_t i = 0; i < segments_; ++i) {
            const std::uint32_t next = (i + 1) % segments_;
            result_.triangles.push_back({i, segments_ + i, next});
            if (top > 0) result_.triangles.push_back({next, segments_ + i, segments_ + next});
        }
    }

    /// Disc at the height y; `up`: its front is seen from +y.
    void disc(double radius, double y, bool up) {
        const auto first = static_cast<std::uint32_t>(result_.positions.size());
        const Vec3 normal{0, up ? 1.0 : -1.0, 0};
        for (std::uint32_t i = 0; i < segments_; ++i) push(at(i) * radius + Vec3{0, y, 0}, normal);
        for (std::uint32_t i = 1; i + 1 < segments_; ++i) {
            const std::uint32_t a = first + i, b = first + i + 1;
            result_.triangles.push_back({first, up ? b : a, up ? a : b});
        }
    }

    /// `radius` and `y` of the largest circle, and how many circles were made before it.
    Tessellation result(double radius, double y, std::uint32_t circle = 0) && {
        const std::uint32_t first = circle * segments_;
        result_.deviation = ringDeviation(result_, first, segments_, radius) +
                            std::abs(widened(result_.positions[first]).y - y);
        return std::move(result_);
    }

private:
    Vec3 at(double i) const { return onCircle(i / segments_); }
    void push(Vec3 position, Vec3 normal) {
        result_.positions.push_back(rounded(position));
        result_.normals.push_back(rounded(normal));
    }

    std::uint32_t segments_;
    Tessellation result_;
};

} // namespace

Vec3f rounded(Vec3 v) {
    const auto nearest = [](double c) {
        constexpr double most = std::numeric_limits<float>::max();
        return static_cast<float>(std::clamp(c, -most, most));
    };
    return {nearest(v.x), nearest(v.y), nearest(v.z)};
}

Vec3 widened(const Vec3f& v) { return {v[0], v[1], v[2]}; }

Tessellation tessellateSphere(double radius, double chordError) {
    // In the middle of an octahedron's face the triangles are largest: a circle through their corners spans
    // pi/sqrt(6)/n = 1.283/n from its middle, for large n.
    const double aim = std::numbers::pi / std::sqrt(6.0) / halfAngle(radius, chordError);
    for (int n = std::max(4, static_cast<int>(aim));; ++n) {
        Tessellation result = SphereGrid(radius, n).result();
        result.deviation = sphereDeviation(result, radius);
        if (result.deviation <= chordError || n > aim + 1) return result;
    }
}

Tessellation tessellateBox(Vec3 sides) {
    Tessellation result;
    for (int i = 0; i < 8; ++i)
        result.positions.push_back(
            rounded({i & 1 ? sides.x / 2 : -sides.x / 2, i & 2 ? sides.y / 2 : -sides.y / 2,
                     i & 4 ? sides.z / 2 : -sides.z / 2}));
    constexpr std::uint32_t faces[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                           {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
    for (const auto& [a, b, c, d] : faces) {
        result.triangles.push_back({a, b, c});
        result.triangles.push_back({a, c, d});
    }
    result.deviation = length(widened(result.positions[7]) - sides / 2);
    return result;
}

Tessellation tessellateCone(double bottom, double top, double height, Lids lids, double chordError) {
    RoundBuilder round(segmentsOf(std::max(bottom, top), chordError));
    round.wall(bottom, top, height / 2);
    if (lids.bottom) round.disc(bottom, -height / 2, false);
    if (lids.top) round.disc(top, height / 2, true);
    return top > bottom ? std::move(round).result(top, height / 2, 1)
                        : std::move(round).result(bottom, -height / 2);
}

Tessellation tessellateDisc(double radius, double chordError) {
    RoundBuilder round(segmentsOf(radius, chordError));
    round.disc(radius, 0, true);
    return std::move(round).result(radius, 0);
}

Tessellation tessellateSquare(double reach) {
    Tessellation result;
    for (const auto& [x, z] : {std::pair{-1, -1}, {-1, 1}, {1, 1}, {1, -1}})
        result.positions.push_back(rounded(Vec3{x * reach, 0, z * reach}));
    result.triangles = {{0, 1, 2}, {0, 2, 3}};
    return result;
}

} // namespace yarte::convert
