// Outlines in a plane, cut into triangles. Private to tessellate_polygon.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace yarte::convert {

struct Point2 {
    double u = 0, v = 0;
    friend bool operator==(Point2, Point2) = default;
};

/// Twice the area of the triangle; positive if it is counter-clockwise.
constexpr double doubleArea(Point2 a, Point2 b, Point2 c) {
    return (b.u - a.u) * (c.v - a.v) - (b.v - a.v) * (c.u - a.u);
}

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

/// True if no two edges meet but neighbours in their vertex.
bool isSimple(const std::vector<Point2>& outline);

/// Counter-clockwise triangles of a simple, counter-clockwise outline, by clipping ears; vertices within
/// straight edges may be left out. Nothing if rounding leaves no ear.
std::optional<Triangles> clipEars(const std::vector<Point2>& outline);

/// A point of an outline's edge from vertex `edge` to the next: the part `t`, from 0 to 1, of the way.
struct EdgePoint {
    std::uint32_t edge = 0;
    double t = 0;
    friend bool operator==(EdgePoint, EdgePoint) = default;
};

/// Counter-clockwise triangles of the inside, even-odd, of any outline: it is cut along u at every vertex and
/// crossing, and between two cuts into trapezoids.
std::vector<std::array<EdgePoint, 3>> cutIntoTrapezoids(const std::vector<Point2>& outline);

} // namespace yarte::convert
