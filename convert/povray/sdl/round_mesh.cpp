#include "convert/povray/sdl/round_mesh.h"

#include "convert/povray/sdl/stretch.h"
#include "convert/tessellate.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace yarte::convert::povray::sdl {
namespace {

using Index = std::uint32_t;

/// As a part of the radius, within what makes sense, whatever the numbers.
double relativeError(double radius, double chordError) {
    const double part = chordError / radius;
    return part < 1 ? std::max(part, leastRelativeChordError) : 1;
}

/// Of a whole turn, so that the middle of a chord is at most `chordError` from its circle.
Index segmentsOf(double radius, double chordError) {
    constexpr double least = 12;
    const double part = relativeError(radius, chordError);
    return static_cast<Index>(std::max(least, std::ceil(std::numbers::pi / std::acos(1 - part))));
}

/// Of the middle of a chord from its circle.
double sagitta(double radius, Index segments) { return radius * (1 - std::cos(std::numbers::pi / segments)); }

class Builder {
public:
    Index vertex(Vec3 position) {
        data_.vertices.push_back(position);
        return static_cast<Index>(data_.vertices.size() - 1);
    }
    Index normal(Vec3 n) {
        data_.normals.push_back(n);
        return static_cast<Index>(data_.normals.size() - 1);
    }
    struct Corner {
        Index vertex, normal;
    };
    void triangle(Corner a, Corner b, Corner c) {
        data_.corners.insert(data_.corners.end(), {a.vertex, b.vertex, c.vertex});
        data_.cornerNormals.insert(data_.cornerNormals.end(), {a.normal, b.normal, c.normal});
        data_.faceStarts.push_back(static_cast<Index>(data_.corners.size()));
    }
    RoundMesh result(double deviation) && { return {std::move(data_), deviation}; }

private:
    MeshData data_;
};

/// Directions around the axis `along`, counter-clockwise seen from its tip.
class Turn {
public:
    Turn(Vec3 along, Index segments) : x_(perpendicular(along)), y_(cross(along, x_)), segments_(segments) {}
    Vec3 at(double i) const {
        const double angle = 2 * std::numbers::pi * i / segments_;
        return x_ * std::cos(angle) + y_ * std::sin(angle);
    }

private:
    Vec3 x_, y_;
    double segments_;
};

} // namespace

RoundMesh sphereMesh(Vec3 centre, double radius, double chordError) {
    const Tessellation unitSphere = tessellateSphere(1, relativeError(radius, chordError));
    Builder builder;
    for (const Vec3f& p : unitSphere.positions) builder.vertex(centre + widened(p) * radius);
    for (const Vec3f& n : unitSphere.normals) builder.normal(widened(n));
    for (const auto& [a, b, c] : unitSphere.triangles) builder.triangle({a, a}, {b, b}, {c, c});
    return std::move(builder).result(unitSphere.deviation * radius);
}

RoundMesh coneMesh(Vec3 a, double radiusA, Vec3 b, double radiusB, bool isOpen, double chordError) {
    const double widest = std::max(radiusA, radiusB);
    const Index segments = segmentsOf(widest, chordError);
    const double height = lengthOf(b - a);
    const Vec3 along = unit(b - a);
    const Turn turn(along, segments);
    const double lean = std::atan2(radiusA - radiusB, height); // of the wall's normals, towards b
    const auto wallNormal = [&](double i) { return turn.at(i) * std::cos(lean) + along * std::sin(lean); };

    Builder builder;
    const auto ring = [&](Vec3 centre, double radius) {
        for (Index i = 0; i < segments; ++i) builder.vertex(centre + turn.at(i) * radius);
    };
    // First A's ring, then B's; a tip is a ring of one point.
    const Index ringB = radiusA > 0 ? segments : 1;
    radiusA > 0 ? ring(a, radiusA) : void(builder.vertex(a));
    radiusB > 0 ? ring(b, radiusB) : void(builder.vertex(b));
    for (Index i = 0; i < segments; ++i) builder.normal(wallNormal(i));
    for (Index i = 0; i < segments; ++i) builder.normal(wallNormal(i + 0.5)); // at a tip, for each side
    for (Index i = 0; i < segments; ++i) {
        const Index next = (i + 1) % segments;
        if (radiusA == 0) {
            builder.triangle({0, segments + i}, {ringB + next, next}, {ringB + i, i});
        } else if (radiusB == 0) {
            builder.triangle({i, i}, {next, next}, {ringB, segments + i});
        } else {
            builder.triangle({i, i}, {next, next}, {ringB + next, next});
            builder.triangle({i, i}, {ringB + next, next}, {ringB + i, i});
        }
    }
    const auto lid = [&](Index first, Vec3 normal, bool isTop) {
        const Index n = builder.normal(normal);
        for (Index i = 1; i + 1 < segments; ++i) {
            const Index p = first + i, q = first + i + 1;
            builder.triangle({first, n}, {isTop ? p : q, n}, {isTop ? q : p, n});
        }
    };
    if (!isOpen && radiusA > 0) lid(0, -along, false);
    if (!isOpen && radiusB > 0) lid(ringB, along, true);
    return std::move(builder).result(sagitta(widest, segments));
}

RoundMesh ringMesh(Vec3 centre, Vec3 normal, double radius, double hole, double chordError) {
    const Index segments = segmentsOf(radius, chordError);
    const Turn turn(normal, segments);
    Builder builder;
    const Index n = builder.normal(normal);
    for (Index i = 0; i < segments; ++i) builder.vertex(centre + turn.at(i) * radius);
    if (hole > 0)
        for (Index i = 0; i < segments; ++i) builder.vertex(centre + turn.at(i) * hole);
    else
        builder.vertex(centre);
    for (Index i = 0; i < segments; ++i) {
        const Index next = (i + 1) % segments;
        if (hole > 0) {
            builder.triangle({i, n}, {next, n}, {segments + next, n});
            builder.triangle({i, n}, {segments + next, n}, {segments + i, n});
        } else {
            builder.triangle({i, n}, {next, n}, {segments, n});
        }
    }
    RoundMesh result = std::move(builder).result(sagitta(radius, segments));
    result.data.normals.clear(), result.data.cornerNormals.clear(); // it is flat
    return result;
}

RoundMesh torusMesh(double major, double minor, double chordError) {
    // Around the axis the outermost circle has the largest chords; the errors of both directions add up.
    const Index around = segmentsOf(major + minor, chordError / 2),
                across = segmentsOf(minor, chordError / 2);
    const Turn turn({0, 1, 0}, around);
    Builder builder;
    for (Index i = 0; i < around; ++i)
        for (Index j = 0; j < across; ++j) {
            const double angle = 2 * std::numbers::pi * j / across;
            const Vec3 normal = turn.at(i) * std::cos(angle) + Vec3{0, std::sin(angle), 0};
            builder.normal(normal);
            builder.vertex(turn.at(i) * major + normal * minor);
        }
    for (Index i = 0; i < around; ++i)
        for (Index j = 0; j < across; ++j) {
            const Index next = (i + 1) % around * across, above = (j + 1) % across;
            const Index a = i * across + j, b = next + j, c = next + above, d = i * across + above;
            builder.triangle({a, a}, {b, b}, {c, c});
            builder.triangle({a, a}, {c, c}, {d, d});
        }
    return std::move(builder).result(sagitta(major + minor, around) + sagitta(minor, across));
}

void map(MeshData& data, const Affine& a) {
    if (determinant(a) < 0) // keeps each face's first corner
        for (std::size_t f = 0; f < data.faceCount(); ++f) {
            const std::size_t begin = data.faceStarts[f] + 1, end = data.faceStarts[f + 1];
            const auto reverse = [&](std::vector<std::uint32_t>& v) {
                if (!v.empty())
                    std::reverse(v.begin() + static_cast<std::ptrdiff_t>(begin),
                                 v.begin() + static_cast<std::ptrdiff_t>(end));
            };
            reverse(data.corners), reverse(data.cornerNormals);
        }
    for (Vec3& v : data.vertices) v = mapPoint(a, v);
    for (Vec3& n : data.normals) n = unit(mapNormal(a, n));
}

} // namespace yarte::convert::povray::sdl
