// What rays meet in truth, in closed form: numbers of fifty digits, of which forty are asked for.
#include "validate/truth/true_scene.h"

#include <gtest/gtest.h>

#include <string>

namespace yarte::validate {
namespace {

const Real tiny("1e-40");

#define EXPECT_REAL(a, b) EXPECT_LT(abs(Real(a) - Real(b)), tiny) << Real(a) << " is not " << Real(b)

void expectVector(const RealVec3& v, const RealVec3& expected) {
    EXPECT_REAL(v.x, expected.x);
    EXPECT_REAL(v.y, expected.y);
    EXPECT_REAL(v.z, expected.z);
}

RealRay ray(Vec3 origin, Vec3 towards) { return {origin, normalised(RealVec3(towards) - origin)}; }

ShapeSurface surface(Shape shape) { return {shape, {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}}; }

/// Of a ray that meets the shape.
SurfaceHit met(const ShapeSurface& s, const RealRay& r) {
    const auto hit = firstHit(s, r);
    EXPECT_TRUE(hit.has_value());
    return hit.value_or(SurfaceHit{});
}

TEST(Truth, Sphere) {
    const ShapeSurface sphere = surface(Sphere{{1, 2, 3}, 2});
    const SurfaceHit hit = met(sphere, ray({1, 3, 13}, {1, 3, 0}));
    EXPECT_REAL(hit.distance, 10 - sqrt(Real(3)));
    expectVector(hit.normal, {0, Real(1) / 2, sqrt(Real(3)) / 2});
    EXPECT_REAL(met(sphere, ray({1, 2, 3}, {5, 2, 3})).distance, 2); // from inside
    EXPECT_FALSE(firstHit(sphere, ray({1, 4.5, 13}, {1, 4.5, 0})));
    EXPECT_FALSE(firstHit(sphere, ray({1, 3, 13}, {1, 3, 20}))) << "behind the ray";
}

TEST(Truth, ABoxInItsOwnAxes) {
    // A quarter turn about z: the box's x is the world's y.
    const ShapeSurface box{Box{{0, 0, 0}, {4, 2, 6}}, {Vec3{0, 1, 0}, Vec3{-1, 0, 0}, Vec3{0, 0, 1}}};
    const SurfaceHit above = met(box, ray({0.5, 10, 0}, {0.5, 0, 0}));
    EXPECT_REAL(above.distance, 8);
    expectVector(above.normal, {0, 1, 0});
    EXPECT_REAL(met(box, ray({10, 0, 0}, {0, 0, 0})).distance, 9);
    EXPECT_FALSE(firstHit(box, ray({1.5, 10, 0}, {1.5, 0, 0})));
}

TEST(Truth, ConesFrustumsAndCylinders) {
    // At half its height a cone of radius and height 2 has the radius 1.
    const ShapeSurface cone = surface(Cone{{0, 0, 0}, 2, 2});
    const SurfaceHit side = met(cone, ray({5, 1, 0}, {0, 1, 0}));
    EXPECT_REAL(side.distance, 4);
    expectVector(side.normal, {sqrt(Real(2)) / 2, sqrt(Real(2)) / 2, 0});
    EXPECT_REAL(met(cone, ray({1, -3, 0}, {1, 0, 0})).distance, 3); // its base
    EXPECT_FALSE(firstHit(cone, ray({5, 2.5, 0}, {0, 2.5, 0}))) << "the other nappe";

    const ShapeSurface open = surface(TruncatedCone{{0, 0, 0}, 2, 4, 2}); // radius 1 on top
    EXPECT_REAL(met(open, ray({5, 1, 0}, {0, 1, 0})).distance, 5 - Real(3) / 2);
    EXPECT_FALSE(firstHit(open, ray({0.5, 9, 0}, {0.5, 0, 0}))) << "through both ends";
    EXPECT_REAL(met(open, ray({1.5, 9, 0}, {1.5, 0, 0})).distance, 8); // its wall, from above

    const ShapeSurface closed = surface(Frustum{{0, 0, 0}, 2, 1, 2});
    EXPECT_REAL(met(closed, ray({0.5, 9, 0}, {0.5, 0, 0})).distance, 7); // its lid
    const ShapeSurface tube = surface(OpenCylinder{{0, 0, 0}, 1, 2}),
                       can = surface(Cylinder{{0, 0, 0}, 1, 2});
    EXPECT_FALSE(firstHit(tube, ray({0, 9, 0}, {0, 0, 0})));
    EXPECT_REAL(met(can, ray({0, 9, 0}, {0, 0, 0})).distance, 7);
    EXPECT_REAL(met(tube, ray({0.6, 1, 9}, {0.6, 1, 0})).distance, 9 - Real(sqrt(1 - Real(0.6) * Real(0.6))));
}

TEST(Truth, DiscAndPlane) {
    const ShapeSurface disc = surface(Disc{{1, 2, 3}, 2});
    EXPECT_REAL(met(disc, ray({2, 5, 3}, {2, 0, 3})).distance, 3);
    EXPECT_FALSE(firstHit(disc, ray({3.5, 5, 3}, {3.5, 0, 3})));
    // A normal of any length; 3 away from the origin along it.
    const ShapeSurface plane = surface(Plane{{0, 7, 7}, 3});
    const SurfaceHit hit = met(plane, ray({0, 9, 0}, {0, 0, 0}));
    EXPECT_REAL(hit.distance, 9 - 3 * sqrt(Real(2)));
    expectVector(hit.normal, {0, sqrt(Real(2)) / 2, sqrt(Real(2)) / 2});
    EXPECT_FALSE(firstHit(plane, ray({0, 9, 0}, {5, 9, 0})));
}

TEST(Truth, FacesAreFilledEvenOdd) {
    const FaceSurface arrow{{Vec3{-2, 0, 0}, Vec3{0, 1, 0}, Vec3{2, 0, 0}, Vec3{0, 4, 0}}, {}};
    const auto hit = firstHit(arrow, ray({0, 2, 5}, {0, 2, 0}));
    ASSERT_TRUE(hit);
    EXPECT_REAL(hit->distance, 5);
    EXPECT_REAL(abs(hit->normal.z), 1);
    EXPECT_FALSE(firstHit(arrow, ray({0, 0.5, 5}, {0, 0.5, 0}))) << "in the notch";
}

TEST(Truth, SmoothTrianglesInterpolate) {
    const RealVec3 x = Vec3{1, 0, 0}, y = Vec3{0, 1, 0}, z = Vec3{0, 0, 1};
    const FaceSurface face{{Vec3{0, 0, 0}, Vec3{4, 0, 0}, Vec3{0, 4, 0}}, {x, y, z}};
    const auto hit = firstHit(face, ray({1, 1, 3}, {1, 1, 0})); // weights 1/2, 1/4, 1/4
    ASSERT_TRUE(hit);
    expectVector(hit->normal, normalised(RealVec3(2, 1, 1)));
}

Scene sceneWith(std::vector<Shape> shapes) {
    Scene scene;
    scene.camera.position = {0, 0, 10};
    scene.camera.focus = {0, 0, 0};
    scene.materials.emplace_back();
    for (Shape& shape : shapes) scene.bodies.push_back({std::move(shape), {}, {}, {}, {}});
    return scene;
}

TEST(TrueScene, RaysPassThroughPixelsCentres) {
    const TrueScene scene(sceneWith({}), {4, 2}); // half-angles of 45 degrees
    expectVector(scene.ray(0, 0).origin, Vec3{0, 0, 10});
    expectVector(scene.ray(0, 0).direction, normalised(RealVec3(Vec3{-0.75, 0.5, -1})));
    expectVector(scene.ray(2, 1).direction, normalised(RealVec3(Vec3{0.25, -0.5, -1})));
    EXPECT_FALSE(scene.firstHit(scene.ray(0, 0)));
}

TEST(TrueScene, TheNearestIsMetAndOfTwoAtOnePlaceTheFirst) {
    const Sphere far{{0, 0, -5}, 1}, near{{0, 0, 2}, 1};
    const TrueScene scene(sceneWith({Plane{{0, 0, 1}, -7}, far, near, near}), {1, 1});
    const auto hit = scene.firstHit(scene.ray(0, 0));
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->body, 2);
    EXPECT_REAL(hit->distance, 7);
}

TEST(TrueScene, MeshesArePlaced) {
    Scene scene = sceneWith({Sphere{{0, 0, -50}, 1}});
    scene.meshes.push_back({"", {{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}}, {0, 3}, {0, 1, 2}, {}, {}});
    // Twice as large, turned so that its z is the world's x, and moved.
    scene.bodies.push_back({Mesh{{0}, 2, {{0, 0, -1}, {0, 1, 0}, Vec3{1, 0, 0}}, {3, 0, 0}}, {}, {}, {}, {}});
    EXPECT_EQ(surfaceCount(scene), 2u);
    const TrueScene truth(scene, {1, 1});
    const auto hit = truth.firstHit(ray({0, 0, 0}, {1, 0, 0}));
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->body, 1);
    EXPECT_REAL(hit->distance, 3);
    EXPECT_FALSE(truth.firstHit(ray({0, 2.5, 0}, {1, 2.5, 0})));
}

} // namespace
} // namespace yarte::validate
