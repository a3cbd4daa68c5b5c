#include "yarte/scene/check.h"

#include "yarte/base/number.h"
#include "yarte/scene/planarity.h"
#include "yarte/scene/rules.h"

#include <fmt/format.h>

#include <utility>

namespace yarte {
namespace {

constexpr std::string_view radiusCode = "scene.radius-not-positive";
constexpr std::string_view heightCode = "scene.height-not-positive";

void apply(Rules& rules, const Sphere& s) {
    rules.finite(0, s.centre);
    if (rules.finite(3, {s.radius})) rules.positive(radiusCode, "radius", s.radius, 3);
}

void apply(Rules& rules, const Box& box) {
    rules.finite(0, box.centre);
    if (!rules.finite(3, box.sides)) return;
    int argument = 3;
    for (const double side : {box.sides.x, box.sides.y, box.sides.z})
        rules.positive("scene.side-not-positive", "a box's side", side, argument++);
}

/// The arguments that cones and cylinders share.
void checkRound(Rules& rules, Vec3 centre, double radius, double height) {
    rules.finite(0, centre);
    if (!rules.finite(3, {radius, height})) return;
    rules.positive(radiusCode, "radius", radius, 3);
    rules.positive(heightCode, "height", height, 4);
}

void apply(Rules& rules, const Cone& c) { checkRound(rules, c.centre, c.radius, c.height); }

void apply(Rules& rules, const TruncatedCone& cone) {
    rules.finite(0, cone.centre);
    if (!rules.finite(3, {cone.radius, cone.coneHeight, cone.height})) return;
    rules.positive(radiusCode, "radius", cone.radius, 3);
    rules.positive(heightCode, "the full cone's height", cone.coneHeight, 4);
    rules.positive(heightCode, "height", cone.height, 5);
    if (cone.coneHeight > 0 && cone.height > cone.coneHeight)
        rules.broken({"scene.height-above-cone",
                      fmt::format("the height kept must not exceed the full cone's height, {}, got {}",
                                  printNumber(cone.coneHeight), printNumber(cone.height)),
                      5});
}

void apply(Rules& rules, const Disc& disc) {
    rules.finite(0, disc.centre);
    if (rules.finite(3, {disc.radius})) rules.positive(radiusCode, "radius", disc.radius, 3);
}

/// The first of a vertex's three arguments; argument 0 is the number of vertices.
int argumentOf(std::size_t vertex) { return static_cast<int>(1 + 3 * vertex); }

void apply(Rules& rules, const Polygon& polygon) {
    const std::vector<Vec3>& vertices = polygon.vertices;
    const std::size_t count = vertices.size();
    if (count < 3)
        return rules.broken({"scene.too-few-vertices",
                             fmt::format("a polygon must have at least 3 vertices, got {}", count), 0});
    bool good = true;
    for (std::size_t i = 0; i < count; ++i) good &= rules.finite(argumentOf(i), vertices[i]);
    if (!good) return;
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t next = i + 1 < count ? i + 1 : 0;
        if (vertices[i] != vertices[next]) continue;
        rules.broken({"scene.repeated-vertex",
                      "neighbouring vertices of a polygon must differ, got two alike",
                      argumentOf(next == 0 ? i : next), 3});
        good = false;
    }
    if (!good) return;
    const std::optional<Planarity> flat = planarity(vertices);
    if (!flat) return rules.broken({"scene.no-area", "a polygon must have an area, got none"});
    if (flat->error > maxPlanarityError)
        rules.broken({"scene.polygon-not-planar",
                      fmt::format("a polygon must be planar within {} of its size, got {:.4g} at this vertex",
                                  maxPlanarityError, flat->error),
                      argumentOf(flat->vertex), 3});
}

void apply(Rules& rules, const Mesh& mesh) {
    if (rules.finite(0, {mesh.scale}))
        rules.positive("scene.scale-not-positive", "a mesh's scale", mesh.scale, 0);
    for (Problem problem : check(mesh.axes)) {
        ++problem.argument;
        rules.broken(std::move(problem));
    }
    rules.finite(10, mesh.translation);
}

void apply(Rules& rules, const Cylinder& c) { checkRound(rules, c.centre, c.radius, c.height); }

void apply(Rules& rules, const OpenCylinder& c) { checkRound(rules, c.centre, c.radius, c.height); }

void apply(Rules& rules, const Frustum& f) {
    rules.finite(0, f.centre);
    if (!rules.finite(3, {f.baseRadius, f.topRadius, f.height})) return;
    rules.positive(radiusCode, "the base's radius", f.baseRadius, 3);
    rules.positive(radiusCode, "the top's radius", f.topRadius, 4);
    rules.positive(heightCode, "height", f.height, 5);
}

void apply(Rules& rules, const Plane& plane) {
    if (rules.finite(0, plane.normal) && plane.normal == Vec3{})
        rules.broken({"scene.normal-zero", "a plane's normal must not be 0 0 0", 0, 3});
    rules.finite(3, {plane.distance});
}

} // namespace

Problems check(const Shape& shape) {
    Rules rules;
    std::visit([&](const auto& s) { apply(rules, s); }, shape);
    return std::move(rules).problems();
}

} // namespace yarte
