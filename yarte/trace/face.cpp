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

Vec3 outwardNormal(const FaceShape& s, Vec3 point, std::uint8_t) {
    if (!s.face.isSmooth) return s.face.normal;
    const Vec3 n = s.face.normal;
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

Vec3 newellNormal(std::span<const Vec3> vertices) {
    Vec3 sum;
    for (std::size_t i = 1; i + 1 < vertices.size(); ++i)
        sum += cross(vertices[i] - vertices[0], vertices[i + 1] - vertices[0]);
    return sum;
}

} // namespace yarte::trace
