#include "tests/hard/transform.h"

namespace yarte::hard {
namespace {

template <class... Visitors>
struct Overloaded : Visitors... {
    using Visitors::operator()...;
};

/// Calls `point` with every point of the scene.
template <class Visit>
void forEachPoint(Scene& scene, Visit&& point) {
    point(scene.camera.position), point(scene.camera.focus);
    for (Light& light : scene.lights) point(light.position);
    for (Body& body : scene.bodies)
        std::visit(Overloaded{[&](Polygon& s) {
                                  for (Vec3& vertex : s.vertices) point(vertex);
                              },
                              [&](Mesh& s) { point(s.translation); }, [](Plane&) {},
                              [&](auto& s) { point(s.centre); }},
                   body.shape);
}

/// Calls `length` with every length of the scene that is no coordinate of a point.
template <class Visit>
void forEachLength(Scene& scene, Visit&& length) {
    for (Body& body : scene.bodies)
        std::visit(
            Overloaded{[&](Sphere& s) { length(s.radius); },
                       [&](Box& s) { length(s.sides.x), length(s.sides.y), length(s.sides.z); },
                       [&](Cone& s) { length(s.radius), length(s.height); },
                       [&](TruncatedCone& s) { length(s.radius), length(s.coneHeight), length(s.height); },
                       [&](Disc& s) { length(s.radius); }, [](Polygon&) {}, [&](Mesh& s) { length(s.scale); },
                       [&](Cylinder& s) { length(s.radius), length(s.height); },
                       [&](OpenCylinder& s) { length(s.radius), length(s.height); },
                       [&](Frustum& s) { length(s.baseRadius), length(s.topRadius), length(s.height); },
                       [&](Plane& s) { length(s.distance); }},
            body.shape);
}

} // namespace

Scene scaled(Scene scene, double s) {
    forEachPoint(scene, [&](Vec3& p) { p = p * s; });
    forEachLength(scene, [&](double& length) { length *= s; });
    return scene;
}

Scene moved(Scene scene, Vec3 by) {
    forEachPoint(scene, [&](Vec3& p) { p += by; });
    for (Body& body : scene.bodies)
        if (auto* plane = std::get_if<Plane>(&body.shape))
            plane->distance += dot(unitVector(plane->normal), by);
    return scene;
}

Scene turned(Scene scene, Vec3 (*turn)(Vec3)) {
    forEachPoint(scene, [&](Vec3& p) { p = turn(p); });
    scene.camera.up = turn(scene.camera.up);
    const auto turnAxes = [&](Referential& axes) {
        axes.x = turn(axes.x), axes.y = turn(axes.y);
        if (axes.z) axes.z = turn(*axes.z);
    };
    for (Body& body : scene.bodies) {
        if (auto* plane = std::get_if<Plane>(&body.shape)) plane->normal = turn(plane->normal);
        if (auto* mesh = std::get_if<Mesh>(&body.shape)) turnAxes(mesh->axes);
        if (!takesReferential(body.shape)) continue;
        if (!body.referential) body.referential.emplace();
        turnAxes(*body.referential);
    }
    return scene;
}

Scene nudged(Scene scene, double by, test::Random& random) {
    const auto off = [&](double size) { return random.below(2) == 0 ? size : -size; };
    const auto nudge = [&](Vec3& p, double size) { p += {off(size), off(size), off(size)}; };
    forEachPoint(scene, [&](Vec3& p) { nudge(p, by); });
    for (Body& body : scene.bodies) {
        if (auto* plane = std::get_if<Plane>(&body.shape)) plane->distance += off(by);
        if (auto* mesh = std::get_if<Mesh>(&body.shape))
            for (Vec3& vertex : scene.meshes[mesh->mesh.index].vertices) nudge(vertex, by / mesh->scale);
    }
    return scene;
}

Extent extentOf(Scene scene) {
    Extent extent;
    const auto take = [&](double x) {
        extent.largest = std::max(extent.largest, std::abs(x));
        if (x != 0) extent.smallest = std::min(extent.smallest, std::abs(x));
    };
    forEachPoint(scene, [&](Vec3& p) { take(p.x), take(p.y), take(p.z); });
    forEachLength(scene, take);
    return extent;
}

} // namespace yarte::hard
