// What kernels_bench measures with: a shape of each kind, large fields of spheres and triangles, rays to
// them.
#pragma once

#include "tests/bench/height_field.h"
#include "tests/support/scenes.h"
#include "yarte/scene/referential.h"
#include "yarte/trace/phong.h"

#include <utility>
#include <vector>

namespace yarte::bench {

/// Through the middle size x size pixels, in the tracer's order: blocks of 16 x 16 pixels, in these squares
/// of 4 x 4, which are what a packet holds.
inline std::vector<trace::Ray> cameraRays(const trace::CameraRays& camera, int size) {
    const int x0 = (camera.width - size) / 2, y0 = (camera.height - size) / 2;
    std::vector<trace::Ray> rays;
    for (int block = 0; block < size * size / 256; ++block)
        for (int i = 0; i < 256; ++i) {
            const int square = i / 16, pixel = i % 16;
            rays.push_back(camera.through(x0 + block % (size / 16) * 16 + square % 4 * 4 + pixel % 4,
                                          y0 + block / (size / 16) * 16 + square / 4 * 4 + pixel / 4));
        }
    return rays;
}

/// Down the z axis, to something of size 2 about the origin.
inline Camera cameraInFront() {
    Camera camera;
    camera.position = {0, 0, 8};
    camera.horizontalApertureDegrees = camera.verticalApertureDegrees = 10;
    return camera;
}

/// Those that the shapes of forEachShape are met with.
inline std::vector<trace::Ray> raysToShapes() {
    return cameraRays(trace::CameraRays(cameraInFront(), {32, 32}), 32);
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
/// own. They lie about the origin and cover about half of what raysToShapes goes through.
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

/// Something large with a light, seen by a camera of 1024 x 1024 pixels.
struct Field {
    WorldPtr world;
    std::vector<trace::Ray> rays;   ///< from the camera
    std::vector<trace::Ray> shadow; ///< from where those meet a surface that faces the light, to it
};

inline Field fieldOf(Scene scene, Vec3 light) {
    scene.lights.push_back({light, {1, 1, 1}, {}});
    Field field{buildWorld(scene, {1024, 1024}), {}, {}};
    field.rays = cameraRays(field.world->camera, 256);
    for (const trace::Ray& ray : field.rays) {
        const auto hit = nearestHit(*field.world, ray);
        if (!hit) continue;
        const trace::SurfacePoint point = surfacePoint(*field.world, ray, *hit);
        const Vec3 toLight = normalised(light - point.position);
        if (dot(point.normal, toLight) > 0)
            field.shadow.push_back({point.position, toLight, {point.element, point.viewerSide}});
    }
    return field;
}

/// 10,000 spheres in a cube, of which a ray that misses them all is rare.
inline const Field& sphereField() {
    static const Field field = [] {
        test::Random random(1);
        Scene scene = test::emptyScene();
        scene.camera = cameraInFront();
        for (int i = 0; i < 10000; ++i)
            test::add(scene, Sphere{random.inCube(1), 0.015}, test::matt({1, 1, 1}));
        return fieldOf(std::move(scene), {9, 12, 8});
    }();
    return field;
}

/// A million triangles.
inline const Field& triangleField() {
    static const Field field = [] {
        Scene scene = test::emptyScene();
        scene.camera.position = {0, 1.6, 2.2}, scene.camera.focus = {0, -0.1, 0};
        scene.camera.horizontalApertureDegrees = scene.camera.verticalApertureDegrees = 30;
        test::addMesh(scene, heightField(708), test::matt({1, 1, 1}));
        return fieldOf(std::move(scene), {3, 2, 1});
    }();
    return field;
}

/// Calls `visit(name, field)` for the fields above; they are made when they are first asked for.
template <class Visit>
void forEachField(Visit&& visit) {
    visit("10,000 spheres", sphereField);
    visit("1 million triangles", triangleField);
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
