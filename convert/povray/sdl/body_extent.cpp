#include "convert/povray/sdl/body_extent.h"

#include "yarte/scene/mesh_placement.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

namespace yarte::convert::povray::sdl {
namespace {

struct Measure {
    const Scene& scene;
    Vec3 from, direction;
    Reach reach;

    void ball(Vec3 centre, double radius) {
        const double depth = dot(centre - from, direction);
        if (std::exchange(reach.isEmpty, false))
            reach.nearest = depth - radius, reach.farthest = depth + radius;
        reach.nearest = std::min(reach.nearest, depth - radius);
        reach.farthest = std::max(reach.farthest, depth + radius);
        reach.distance = std::max(reach.distance, length(centre - from) + radius);
    }
    /// Of a body of revolution, around the centre of its base.
    void round(Vec3 centre, double radius, double height) { ball(centre, std::hypot(radius, height)); }

    void operator()(const Sphere& s) { ball(s.centre, s.radius); }
    void operator()(const Box& b) { ball(b.centre, length(b.sides) / 2); }
    void operator()(const Cone& c) { round(c.centre, c.radius, c.height); }
    void operator()(const TruncatedCone& c) { round(c.centre, c.radius, c.height); }
    void operator()(const Cylinder& c) { round(c.centre, c.radius, c.height); }
    void operator()(const OpenCylinder& c) { round(c.centre, c.radius, c.height); }
    void operator()(const Frustum& f) { round(f.centre, std::max(f.baseRadius, f.topRadius), f.height); }
    void operator()(const Disc& d) { ball(d.centre, d.radius); }
    void operator()(const Plane&) { reach.hasPlane = true; }
    void operator()(const Polygon& p) {
        for (const Vec3 v : p.vertices) ball(v, 0);
    }
    void operator()(const Mesh& m) {
        for (const Vec3 v : placedVertices(scene.meshes[m.mesh.index], m)) ball(v, 0);
    }
};

} // namespace

Reach reachOf(const Scene& scene, Vec3 from, Vec3 direction) {
    Measure measure{scene, from, direction, {}};
    for (const Body& body : scene.bodies) std::visit(measure, body.shape);
    return measure.reach;
}

} // namespace yarte::convert::povray::sdl
