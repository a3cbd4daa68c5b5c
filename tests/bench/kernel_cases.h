// What kernels_bench measures with: a shape of each kind, a field of spheres, and rays towards them.
#pragma once

#include "tests/support/scenes.h"
#include "yarte/scene/referential.h"
#include "yarte/trace/search.h"

#include <algorithm>
#include <vector>

namespace yarte::bench {

/// Seen from (0, 0, 8) along the z axis; the rays of a packet belong to a square of 4 x 4 pixels, as those of
/// the tracer do. One such square of every `step` x `step` is taken from a picture of size x size pixels.
inline std::vector<trace::Ray> cameraRays(int size, int step) {
    Camera camera;
    camera.position = {0, 0, 8};
    camera.horizontalApertureDegrees = camera.verticalApertureDegrees = 10;
    const trace::CameraRays through(camera, {size, size});
    std::vector<trace::Ray> rays;
    for (int y0 = 0; y0 < size; y0 += 4 * step)
        for (int x0 = 0; x0 < size; x0 += 4 * step)
            for (int i = 0; i < 16; ++i) rays.push_back(through.through(x0 + i % 4, y0 + i / 4));
    return rays;
}

/// A triangle and a polygon of eight corners.
inline const trace::FaceTable& faces() {
    using trace::Face;
    static const trace::FaceTable table = [] {
        trace::FaceTable t;
        t.vertices = {{-1.2, -0.8, 0.1}, {1.1, -0.9, -0.1}, {0.1, 1.2, 0},  {1, 0, 0},
                      {0.7, 0.7, 0},     {0, 1, 0},         {-0.7, 0.7, 0}, {-1, 0, 0},
                      {-0.7, -0.7, 0},   {0, -1, 0},        {0.7, -0.7, 0}};
        t.corners = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10};
        t.faces = {{0, 3, Face::noPlane, false}, {3, 8, 0, false}};
        t.planes = {computePlane(t, t.faces[1])};
        return t;
    }();
    return table;
}

/// Calls `visit(name, shape)` for a shape of every kind but the triangle, which trees know in a way of their
/// own. They lie about the origin and cover about half of what cameraRays sees.
template <class Visit>
void forEachShape(Visit&& visit) {
    const Frame axes = resolveReferential({{0.8, 0.6, 0}, {-0.6, 0.8, 0}, {}});
    visit("sphere", trace::Sphere(yarte::Sphere{{}, 1.1}));
    visit("box", trace::Box(yarte::Box{{}, {1.7, 1.7, 1.7}}, axes));
    visit("cone", trace::Cone(yarte::Cone{{0.6, -0.8, 0}, 1.2, 2.2}, axes));
    visit("truncated cone", trace::TruncatedCone(yarte::TruncatedCone{{0.5, -0.7, 0}, 1.1, 4, 1.8}, axes));
    visit("frustum", trace::Frustum(yarte::Frustum{{0.5, -0.7, 0}, 1.1, 0.7, 1.8}, axes));
    visit("disc", trace::Disc(yarte::Disc{{}, 1.1}, resolveReferential({{0, 0, 1}, {1, 0, 1}, {}})));
    visit("plane", trace::Plane(yarte::Plane{{1, 2, 3}, 1}));
    visit("polygon", trace::FaceShape{faces(), faces().faces[1]});
}

/// 10,000 spheres in a cube, of which a ray that misses them all is rare, and a light.
inline const World& sphereField() {
    static const WorldPtr world = [] {
        test::Random random(1);
        Scene scene = test::emptyScene();
        scene.camera.position = {0, 0, 8};
        for (int i = 0; i < 10000; ++i)
            test::add(scene, Sphere{random.inCube(2), 0.03}, test::matt({1, 1, 1}));
        scene.lights.push_back({{9, 12, 8}, {1, 1, 1}, {}});
        return buildWorld(scene, {1024, 1024});
    }();
    return *world;
}

/// From where cameraRays meet the field towards its light.
inline std::vector<trace::Ray> shadowRays(const World& world, const std::vector<trace::Ray>& camera) {
    std::vector<trace::Ray> rays;
    for (const trace::Ray& ray : camera) {
        const auto hit = nearestHit(world, ray);
        if (!hit) continue;
        const Vec3 position = ray.at(hit->t);
        rays.push_back({position,
                        normalised(world.lights[0].position - position),
                        {hit->element, hit->entering ? trace::Side::outside : trace::Side::inside}});
    }
    return rays;
}

/// Cosines of mirrored rays and light near a highlight, for Phong's exponent.
inline const std::vector<double>& cosines() {
    static const std::vector<double> values = [] {
        test::Random random(2);
        std::vector<double> made(1024);
        for (double& value : made) value = random.between(0.8, 1);
        return made;
    }();
    return values;
}
inline constexpr double phongExponent = 40;

} // namespace yarte::bench
