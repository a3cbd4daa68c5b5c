#include "convert/surround.h"

#include "yarte/scene/mesh_placement.h"

#include <algorithm>
#include <cmath>
#include <variant>

namespace yarte::convert {
namespace {

/// Turned shapes by balls: their axes do not matter for an order of magnitude.
struct AddShape {
    const Scene& scene;
    Surround& all;

    void operator()(const Sphere& s) const { all.addBall(s.centre, s.radius); }
    void operator()(const Box& b) const { all.addBall(b.centre, length(b.sides) / 2); }
    void operator()(const Cone& c) const { all.addBall(c.centre, std::max(c.radius, c.height)); }
    void operator()(const TruncatedCone& c) const { all.addBall(c.centre, std::hypot(c.radius, c.height)); }
    void operator()(const Disc& d) const { all.addBall(d.centre, d.radius); }
    void operator()(const Polygon& p) const {
        for (const Vec3 v : p.vertices) all.addPoint(v);
    }
    void operator()(const Mesh& m) const {
        for (const Vec3 v : placedVertices(scene.meshes[m.mesh.index], m)) all.addPoint(v);
    }
    void operator()(const Cylinder& c) const { all.addBall(c.centre, std::hypot(c.radius, c.height)); }
    void operator()(const OpenCylinder& c) const { all.addBall(c.centre, std::hypot(c.radius, c.height)); }
    void operator()(const Frustum& f) const {
        all.addBall(f.centre, std::hypot(std::max(f.baseRadius, f.topRadius), f.height));
    }
    void operator()(const Plane& p) const { all.addPoint(footOn(p, scene.camera.position)); }
};

/// In sides of the rest: lights beyond only give a direction, and nothing is the larger for them.
constexpr double distantLight = 1000;

} // namespace

void Surround::addBall(Vec3 centre, double radius) {
    const Vec3 r{radius, radius, radius}, a = centre - r, b = centre + r;
    low = {std::min(low.x, a.x), std::min(low.y, a.y), std::min(low.z, a.z)};
    high = {std::max(high.x, b.x), std::max(high.y, b.y), std::max(high.z, b.z)};
}

double Surround::longestSide() const {
    const Vec3 sides = high - low;
    return std::max({sides.x, sides.y, sides.z});
}

Surround surroundOf(const Scene& scene) {
    Surround all;
    all.addPoint(scene.camera.position);
    for (const Body& body : scene.bodies) std::visit(AddShape{scene, all}, body.shape);
    const double side = all.longestSide();
    const Vec3 centre = all.centre();
    for (const Light& light : scene.lights)
        if (side == 0 || length(light.position - centre) < distantLight * side) all.addPoint(light.position);
    return all;
}

Vec3 footOn(const Plane& plane, Vec3 p) {
    const Vec3 normal = unitVector(plane.normal);
    return p + normal * (plane.distance - dot(p, normal));
}

} // namespace yarte::convert
