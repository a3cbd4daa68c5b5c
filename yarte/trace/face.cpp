#include "yarte/trace/face.h"

namespace yarte::trace {
namespace {

struct Point2 {
    double x, y;
};

double doubleArea(Point2 a, Point2 b, Point2 c) {
    return (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
}

} // namespace

/// Newell's normal [Sutherland, Sproull, Schumacker 1974] as a sum of cross products relative to the first
/// vertex, so that a small polygon far from the origin keeps its digits.
FacePlane computePlane(const FaceTable& table, const Face& face) {
    const auto corners = table.cornersOf(face);
    const Vec3 first = table.vertices[corners[0]];
    if (corners.size() == 3)
        return {triangleNormal(first, table.vertices[corners[1]], table.vertices[corners[2]]), first};
    Twofold3 areaVector, sum;
    for (std::size_t i = 1; i < corners.size(); ++i) {
        const Twofold3 edge = Twofold3(table.vertices[corners[i]]) - first;
        if (i + 1 < corners.size())
            areaVector = areaVector + cross(edge, Twofold3(table.vertices[corners[i + 1]]) - first);
        sum = sum + edge;
    }
    const Twofold3 mean = Twofold3(first) + sum * (Twofold(1) / static_cast<double>(corners.size()));
    return {normalised(areaVector.rounded()), mean.rounded()};
}

Vec3 outwardNormal(const FaceShape& s, Vec3 point, std::uint8_t) {
    const Vec3 n = planeOf(s.table, s.face).normal;
    if (!s.face.isSmooth) return n;
    const double ax = std::abs(n.x), ay = std::abs(n.y), az = std::abs(n.z);
    const auto flatten = [&](Vec3 v) -> Point2 {
        if (ax >= ay && ax >= az) return {v.y, v.z};
        if (ay >= az) return {v.z, v.x};
        return {v.x, v.y};
    };
    const auto corners = s.table.cornersOf(s.face);
    const Point2 a = flatten(s.table.vertices[corners[0]]), b = flatten(s.table.vertices[corners[1]]),
                 c = flatten(s.table.vertices[corners[2]]), p = flatten(point);
    const auto normal = [&](std::uint32_t corner) {
        return s.table.normals[s.table.cornerNormals[s.face.firstCorner + corner]];
    };
    const Vec3 sum =
        doubleArea(p, b, c) * normal(0) + doubleArea(a, p, c) * normal(1) + doubleArea(a, b, p) * normal(2);
    // The weights carry the sign of the projected winding.
    const Vec3 interpolated = doubleArea(a, b, c) < 0 ? -sum : sum;
    return interpolated == Vec3{} ? n : normalised(interpolated);
}

} // namespace yarte::trace
