#include "convert/povray/sdl/build_round.h"

#include "convert/povray/sdl/round_mesh.h"
#include "convert/povray/sdl/stretch.h"

#include <algorithm>
#include <cmath>

namespace yarte::convert::povray::sdl {
namespace {

Built nothing(std::string why) { return {std::monostate(), {}, 0, std::move(why)}; }

Built exactly(Shape shape, std::optional<Referential> axes = {}) {
    return {std::move(shape), std::move(axes), 0, {}};
}

/// The nearest shape of YARTE's.
Built nearly(Shape shape, std::optional<Referential> axes, double deviation) {
    return {std::move(shape), std::move(axes), deviation,
            "as if the transformation kept right angles and circles"};
}

Built meshOf(RoundMesh mesh, const Affine& a, std::string why) {
    map(mesh.data, a);
    return {std::move(mesh.data), {}, mesh.deviation * largestStretch(a), std::move(why)};
}

/// Before the map.
double chordErrorFor(double radius, const Affine& a, Tolerance tolerance) {
    const double stretch = largestStretch(a);
    return tolerance.of(radius * stretch) / stretch;
}

/// What an affine map makes of a unit circle.
struct Circle {
    double radius = 1; ///< of the circle nearest to the image
    double error = 0;  ///< distance of the image from it
};

/// Of the circle around `normal`; it is wanted perpendicular to `axis`. Neither needs a length of 1.
Circle circleOf(const Affine& a, Vec3 normal, Vec3 axis) {
    const Vec3 u = perpendicular(unit(normal)), v = cross(unit(normal), u);
    const Vec3 p = mapDirection(a, u), q = mapDirection(a, v);
    const Similarity similarity = similarityOf(a);
    if (similarity.error <= rounding) return {similarity.scale, 0};
    const double lp = lengthOf(p), lq = lengthOf(q);
    const double radius = lp == lq ? lp : std::hypot(lp, lq) / std::sqrt(2.0);
    const Circle wrong{radius, radius};
    if (axis == Vec3{} || !isFinite(axis) || !(radius > 0) || !std::isfinite(radius)) return wrong;
    const Vec3 along = unit(axis), inPlane = p - along * dot(along, p);
    if (inPlane == Vec3{}) return wrong;
    const Vec3 x = unit(inPlane), across = cross(along, x), y = dot(across, q) < 0 ? -across : across;
    return {radius, lengthOf(p - x * radius) + lengthOf(q - y * radius)};
}

/// The mesh only if `error` is too much for the shape.
template <class MakeShape, class MakeMesh>
Built shapeOrMesh(double size, double error, Tolerance tolerance, MakeShape makeShape, MakeMesh makeMesh) {
    // Numbers that overflow are refused with the shape.
    if (error <= rounding * size || !std::isfinite(size) || !std::isfinite(error)) return makeShape(0.0);
    if (error <= tolerance.of(size)) return makeShape(error);
    return makeMesh();
}

Built shaped(Shape shape, std::optional<Referential> axes, double error) {
    return error == 0 ? exactly(std::move(shape), std::move(axes))
                      : nearly(std::move(shape), std::move(axes), error);
}

/// The six faces of a box whose edges are no longer perpendicular: exact but for its name.
MeshData parallelepiped(Vec3 low, Vec3 high, const Affine& a) {
    MeshData data;
    for (int i = 0; i < 8; ++i)
        data.vertices.push_back({i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z});
    data.corners = {0, 4, 6, 2, 1, 3, 7, 5, 0, 1, 5, 4, 2, 6, 7, 3, 0, 2, 3, 1, 4, 5, 7, 6};
    data.faceStarts = {0, 4, 8, 12, 16, 20, 24};
    map(data, a);
    return data;
}

/// A box without thickness, which POV-Ray shows.
Built flatBox(Vec3 low, Vec3 high, const Affine& a) {
    const Vec3 s = high - low;
    const int flat = (s.x == 0) + (s.y == 0) + (s.z == 0);
    if (flat > 1) return nothing("a box without area");
    Polygon polygon;
    const Vec3 u = s.x == 0 ? Vec3{0, s.y, 0} : Vec3{s.x, 0, 0}, v = s - u;
    for (const Vec3 corner : {low, low + u, high, low + v}) polygon.vertices.push_back(mapPoint(a, corner));
    return exactly(std::move(polygon));
}

} // namespace

Built build(const SphereShape& s, const Affine& a, Tolerance tolerance) {
    const double radius = std::abs(s.radius);
    if (radius == 0) return nothing("the radius is 0");
    const Similarity similarity = similarityOf(a);
    return shapeOrMesh(
        radius * similarity.scale, radius * similarity.scale * similarity.error, tolerance,
        [&](double error) {
            return shaped(Sphere{mapPoint(a, s.centre), radius * similarity.scale}, {}, error);
        },
        [&] {
            return meshOf(sphereMesh(s.centre, radius, chordErrorFor(radius, a, tolerance)), a,
                          "an ellipsoid");
        });
}

Built build(const BoxShape& b, const Affine& a) {
    const Vec3 low{std::min(b.a.x, b.b.x), std::min(b.a.y, b.b.y), std::min(b.a.z, b.b.z)};
    const Vec3 high{std::max(b.a.x, b.b.x), std::max(b.a.y, b.b.y), std::max(b.a.z, b.b.z)};
    const Vec3 sides = high - low;
    if (sides.x == 0 || sides.y == 0 || sides.z == 0) return flatBox(low, high, a);
    const Vec3 size{lengthOf(a.x), lengthOf(a.y), lengthOf(a.z)};
    // The versors, right-handed: of a box both senses of an axis are the same.
    const Vec3 x = a.x / size.x, y = a.y / size.y, z = (determinant(a) < 0 ? -a.z : a.z) / size.z;
    const bool isSquare =
        std::max({std::abs(dot(x, y)), std::abs(dot(y, z)), std::abs(dot(z, x))}) <= rounding;
    if (!isSquare) return {parallelepiped(low, high, a), {}, 0, {}}; // also where numbers overflow
    const Box box{mapPoint(a, low + sides / 2), {sides.x * size.x, sides.y * size.y, sides.z * size.z}};
    const bool isTurned = std::abs(x.x) != 1 || std::abs(y.y) != 1 || std::abs(z.z) != 1;
    return exactly(box, isTurned ? std::optional(Referential{x, y, z}) : std::nullopt);
}

Built build(const ConeShape& c, const Affine& a, Tolerance tolerance) {
    Vec3 base = c.a, top = c.b;
    double baseRadius = c.radiusA, topRadius = c.radiusB;
    if (baseRadius <= 0 && topRadius <= 0) baseRadius = std::abs(baseRadius), topRadius = std::abs(topRadius);
    if (baseRadius < 0 || topRadius < 0) return nothing("the radii have different signs");
    if (base == top || (baseRadius == 0 && topRadius == 0)) return nothing("it has no height or no radius");
    const bool needsNarrowTop = c.open || baseRadius == 0;
    if (needsNarrowTop && baseRadius < topRadius) std::swap(base, top), std::swap(baseRadius, topRadius);

    const Vec3 axis = mapDirection(a, top - base);
    const Circle turn = circleOf(a, top - base, axis);
    const double widest = std::max(baseRadius, topRadius);
    const auto make = [&](double error) {
        const Vec3 centre = mapPoint(a, base);
        const double r = baseRadius * turn.radius, s = topRadius * turn.radius, height = lengthOf(axis);
        const bool isCylinder = std::abs(r - s) <= rounding * r;
        const auto shape = [&]() -> Shape {
            if (isCylinder && c.open) return OpenCylinder{centre, r, height};
            if (isCylinder) return Cylinder{centre, r, height};
            if (c.open) return TruncatedCone{centre, r, s == 0 ? height : height * (r / (r - s)), height};
            if (s == 0) return Cone{centre, r, height};
            return Frustum{centre, r, s, height};
        };
        return shaped(shape(), axesAlong(unit(axis)), error);
    };
    return shapeOrMesh(widest * turn.radius, widest * turn.error, tolerance, make, [&] {
        const double chordError = chordErrorFor(widest, a, tolerance);
        return meshOf(coneMesh(base, baseRadius, top, topRadius, c.open, chordError), a,
                      topRadius == baseRadius ? "an elliptic or slanting cylinder"
                                              : "an elliptic or slanting cone");
    });
}

Built build(const DiscShape& d, const Affine& a, Tolerance tolerance) {
    const double radius = std::abs(d.radius), hole = std::abs(d.hole);
    if (d.normal == Vec3{} || radius <= hole) return nothing("it has no area");
    const Vec3 normal = unit(d.normal), mapped = mapNormal(a, normal);
    if (mapped == Vec3{}) return nothing("its transformation leaves it no area");
    const Circle turn = circleOf(a, normal, mapped);
    const auto mesh = [&](const char* why) {
        return meshOf(ringMesh(d.centre, normal, radius, hole, chordErrorFor(radius, a, tolerance)), a, why);
    };
    if (hole > 0) return mesh("a disc with a hole");
    return shapeOrMesh(
        radius * turn.radius, radius * turn.error, tolerance,
        [&](double error) {
            return shaped(Disc{mapPoint(a, d.centre), radius * turn.radius}, axesAlong(unit(mapped)), error);
        },
        [&] { return mesh("an ellipse"); });
}

Built build(const TorusShape& t, const Affine& a, Tolerance tolerance) {
    const double major = std::abs(t.major), minor = std::abs(t.minor);
    if (minor == 0) return nothing("the minor radius is 0");
    return meshOf(torusMesh(major, minor, chordErrorFor(minor, a, tolerance)), a, "a torus");
}

Built build(const PlaneShape& p, const Affine& a) {
    if (p.normal == Vec3{}) return nothing("the normal is of length 0");
    if (a == Affine{}) return exactly(Plane{p.normal, p.distance});
    const Vec3 normal = mapNormal(a, p.normal);
    if (normal == Vec3{}) return nothing("its transformation flattens space");
    const Vec3 n = unit(normal);
    return exactly(Plane{n, dot(n, mapPoint(a, unit(p.normal) * p.distance))});
}

} // namespace yarte::convert::povray::sdl
