#include "tests/scene/expect_problems.h"

namespace yarte {
namespace {

using test::expectGood;
using test::expectProblem;
using test::infinity;

constexpr std::string_view radiusCode = "scene.radius-not-positive", heightCode = "scene.height-not-positive";

TEST(CheckShape, GoodOnesAreGood) {
    expectGood(check(Shape(Sphere{})));
    expectGood(check(Shape(Box{})));
    expectGood(check(Shape(Cone{})));
    expectGood(check(Shape(TruncatedCone{{}, 1, 2, 2})));
    expectGood(check(Shape(Disc{})));
    expectGood(check(Shape(Polygon{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}})));
    expectGood(check(Shape(Mesh{})));
    expectGood(check(Shape(Cylinder{})));
    expectGood(check(Shape(OpenCylinder{})));
    expectGood(check(Shape(Frustum{{}, 1, 2, 3})));
    expectGood(check(Shape(Frustum{{}, 2, 2, 3})));
    expectGood(check(Shape(Plane{{0, 0, -1e-300}, -2})));
}

TEST(CheckShape, RadiiArePositive) {
    expectProblem(check(Shape(Sphere{{}, -2})), radiusCode, "radius must be positive, got -2", 3);
    expectProblem(check(Shape(Sphere{{}, 0})), radiusCode, "radius must be positive, got 0", 3);
    expectProblem(check(Shape(Disc{{}, -0.5})), radiusCode, "radius must be positive, got -0.5", 3);
    expectProblem(check(Shape(Cone{{}, -1, 1})), radiusCode, "radius must be positive, got -1", 3);
    expectProblem(check(Shape(TruncatedCone{{}, -1, 1, 1})), radiusCode, "radius must be positive, got -1",
                  3);
}

TEST(CheckShape, CylindersAndFrustums) {
    expectProblem(check(Shape(Cylinder{{}, -1, 1})), radiusCode, "radius must be positive, got -1", 3);
    expectProblem(check(Shape(Cylinder{{}, 1, 0})), heightCode, "height must be positive, got 0", 4);
    expectProblem(check(Shape(OpenCylinder{{}, 0, 1})), radiusCode, "radius must be positive, got 0", 3);
    expectProblem(check(Shape(OpenCylinder{{}, 1, -2})), heightCode, "height must be positive, got -2", 4);
    expectProblem(check(Shape(Frustum{{}, 0, 1, 1})), radiusCode, "the base's radius must be positive, got 0",
                  3);
    expectProblem(check(Shape(Frustum{{}, 1, -1, 1})), radiusCode,
                  "the top's radius must be positive, got -1", 4);
    expectProblem(check(Shape(Frustum{{}, 1, 1, 0})), heightCode, "height must be positive, got 0", 5);
}

TEST(CheckShape, APlaneHasANormal) {
    expectProblem(check(Shape(Plane{{0, -0.0, 0}, 1})), "scene.normal-zero",
                  "a plane's normal must not be 0 0 0", 0, 3);
    expectProblem(check(Shape(Plane{{0, infinity, 0}, 1})), "scene.not-finite",
                  "a number must be finite, got inf", 1);
    expectProblem(check(Shape(Plane{{0, 1, 0}, infinity})), "scene.not-finite",
                  "a number must be finite, got inf", 3);
}

TEST(CheckShape, HeightsAndSides) {
    expectProblem(check(Shape(Box{{}, {1, 0, 1}})), "scene.side-not-positive",
                  "a box's side must be positive, got 0", 4);
    EXPECT_EQ(check(Shape(Box{{}, {-1, -1, -1}})).size(), 3U);
    expectProblem(check(Shape(Cone{{}, 1, 0})), heightCode, "height must be positive, got 0", 4);
    expectProblem(check(Shape(TruncatedCone{{}, 1, 0, 1})), heightCode,
                  "the full cone's height must be positive, got 0", 4);
    expectProblem(check(Shape(TruncatedCone{{}, 1, 2, 0})), heightCode, "height must be positive, got 0", 5);
    expectProblem(check(Shape(TruncatedCone{{}, 40, 30, 80})), "scene.height-above-cone",
                  "the height kept must not exceed the full cone's height, 30, got 80", 5);
}

TEST(CheckShape, EveryNumberIsFinite) {
    const Vec3 bad{0, 0, infinity};
    for (const Shape& shape : std::initializer_list<Shape>{
             Sphere{bad, 1}, Box{bad, {1, 1, 1}}, Cone{bad, 1, 1}, TruncatedCone{bad, 1, 1, 1}, Disc{bad, 1},
             Cylinder{bad, 1, 1}, OpenCylinder{bad, 1, 1}, Frustum{bad, 1, 1, 1}, Plane{bad, 1}})
        expectProblem(check(shape), "scene.not-finite", "a number must be finite, got inf", 2);
    expectProblem(check(Shape(Sphere{{}, std::nan("")})), "scene.not-finite",
                  "a number must be finite, got nan", 3);
}

TEST(CheckPolygon, NeedsThreeDifferentVertices) {
    expectProblem(check(Shape(Polygon{{{0, 0, 0}, {1, 0, 0}}})), "scene.too-few-vertices",
                  "a polygon must have at least 3 vertices, got 2", 0);
    expectProblem(check(Shape(Polygon{{{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {0, 1, 0}}})),
                  "scene.repeated-vertex", "neighbouring vertices of a polygon must differ, got two alike", 7,
                  3);
    expectProblem(check(Shape(Polygon{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}}})),
                  "scene.repeated-vertex", "neighbouring vertices of a polygon must differ, got two alike",
                  10, 3);
}

TEST(CheckPolygon, AVertexMayComeAgain) { // a bridge to a hole
    expectGood(check(Shape(
        Polygon{{{0, 0, 0}, {9, 0, 0}, {0, 9, 0}, {0, 0, 0}, {1, 1, 0}, {1, 2, 0}, {2, 1, 0}, {1, 1, 0}}})));
}

TEST(CheckPolygon, NeedsAnArea) {
    expectProblem(check(Shape(Polygon{{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}})), "scene.no-area",
                  "a polygon must have an area, got none", -1);
    // A bow-tie's two halves cancel: no normal by Newell's rule.
    expectProblem(check(Shape(Polygon{{{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}})), "scene.no-area",
                  "a polygon must have an area, got none", -1);
}

TEST(CheckPolygon, IsNearlyPlanar) {
    const auto square = [](double z) {
        return Shape(Polygon{{{1, 1, z}, {-1, 1, -z}, {-1, -1, z}, {1, -1, -z}}});
    };
    expectGood(check(square(2.8e-3))); // of the size, 2 sqrt 2, by less than 1e-3
    expectProblem(check(square(0.2)), "scene.polygon-not-planar",
                  "a polygon must be planar within 0.001 of its size, got 0.07001 at this vertex", 1, 3);
}

TEST(CheckMeshShape, ScaleAndAxes) {
    Mesh mesh;
    mesh.axes.z = Vec3{0, 0, 1};
    expectGood(check(Shape(mesh)));
    mesh.axes.z = Vec3{}; // to be completed
    expectGood(check(Shape(mesh)));
    mesh.scale = 0;
    expectProblem(check(Shape(mesh)), "scene.scale-not-positive", "a mesh's scale must be positive, got 0",
                  0);
    mesh.scale = 1, mesh.axes.z = Vec3{0, 0, -1};
    expectProblem(check(Shape(mesh)), "scene.bad-axes",
                  "axes are left-handed: z is at 180 degrees from x cross y", 1, 9);
    mesh.axes.z = Vec3{0, 0, 1}, mesh.translation.y = infinity;
    expectProblem(check(Shape(mesh)), "scene.not-finite", "a number must be finite, got inf", 11);
    mesh.translation = {}, mesh.axes.x.x = infinity;
    expectProblem(check(Shape(mesh)), "scene.not-finite", "a number must be finite, got inf", 1);
}

} // namespace
} // namespace yarte
