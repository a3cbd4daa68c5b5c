#include "convert/povray/extent.h"

#include "yarte/scene/mesh_placement.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

namespace yarte::convert::povray {
namespace {

class Surround {
public:
    void point(Vec3 p) { ball(p, 0); }
    void ball(Vec3 centre, double radius) {
        const Vec3 r{radius, radius, radius}, a = centre - r, b = centre + r;
        low_ = {std::min(low_.x, a.x), std::min(low_.y, a.y), std::min(low_.z, a.z)};
        high_ = {std::max(high_.x, b.x), std::max(high_.y, b.y), std::max(high_.z, b.z)};
    }
    double longestSide() const {
        const Vec3 sides = high_ - low_;
        return std::max({sides.x, sides.y, sides.z});
    }

private:
    static constexpr double infinity = std::numeric_limits<double>::infinity();
    Vec3 low_{infinity, infinity, infinity}, high_{-infinity, -infinity, -infinity};
};

/// Turned shapes by balls: their axes do not matter for an order of magnitude.
struct AddShape {
    const Scene& scene;
    Surround& all;

    void operator()(const Sphere& s) const { all.ball(s.centre, s.radius); }
    void operator()(const Box& b) const { all.ball(b.centre, length(b.sides) / 2); }
    void operator()(const Cone& c) const { all.ball(c.centre, std::max(c.radius, c.height)); }
    void operator()(const TruncatedCone& c) const { all.ball(c.centre, std::hypot(c.radius, c.height)); }
    void operator()(const Disc& d) const { all.ball(d.centre, d.radius); }
    void operator()(const Polygon& p) const {
        for (const Vec3 v : p.vertices) all.point(v);
    }
    void operator()(const Mesh& m) const {
        for (const Vec3 v : placedVertices(scene.meshes[m.mesh.index], m)) all.point(v);
    }
};

} // namespace

double extentOf(const Scene& scene) {
    Surround all;
    all.point(scene.camera.position);
    for (const Light& light : scene.lights) all.point(light.position);
    for (const Body& body : scene.bodies) std::visit(AddShape{scene, all}, body.shape);
    return all.longestSide();
}

double worldScaleFor(double extent) {
    if (!(extent > 0) || !std::isfinite(extent)) return 1;
    return std::exp2(std::clamp(std::ceil(std::log2(1e5 / extent)), -1000.0, 1000.0));
}

} // namespace yarte::convert::povray
