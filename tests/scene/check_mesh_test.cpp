#include "tests/scene/expect_problems.h"

namespace yarte {
namespace {

using test::expectGood;
using test::expectProblem;

/// A mesh of one face over all its vertices.
MeshData oneFace(std::vector<Vec3> vertices) {
    MeshData mesh;
    mesh.vertices = std::move(vertices);
    for (std::uint32_t i = 0; i < mesh.vertices.size(); ++i) mesh.corners.push_back(i);
    mesh.faceStarts.push_back(static_cast<std::uint32_t>(mesh.corners.size()));
    return mesh;
}

const MeshData triangle = oneFace({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});

TEST(CheckMesh, GoodOnes) {
    expectGood(check(triangle));
    MeshData smooth = triangle;
    smooth.normals = {{0, 0, 1}};
    smooth.cornerNormals = {0, 0, 0};
    expectGood(check(smooth));
}

TEST(CheckMesh, HasAFace) {
    expectProblem(check(MeshData{}), "scene.mesh-empty", "a mesh must have at least one face, got none", -1);
}

TEST(CheckMesh, FacesHaveThreeVertices) {
    expectProblem(check(oneFace({{0, 0, 0}, {1, 0, 0}})), "scene.too-few-vertices",
                  "a face must have at least 3 vertices, got 2", 0);
}

TEST(CheckMesh, FacesWithoutAreaAreKept) {
    expectGood(check(oneFace({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}})));
    expectGood(check(oneFace({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}})));
    MeshData repeated = triangle;
    repeated.corners = {0, 0, 1};
    expectGood(check(repeated));
}

TEST(CheckMesh, FacesAreNearlyPlanar) {
    MeshData mesh = oneFace({{1, 1, 0.2}, {-1, 1, -0.2}, {-1, -1, 0.2}, {1, -1, -0.2}});
    expectProblem(check(mesh), "scene.face-not-planar",
                  "a face must be planar within 0.001 of its size, got 0.07001", 0);
    for (Vec3& v : mesh.vertices) v.z /= 1000;
    expectGood(check(mesh));
}

TEST(CheckMesh, IndicesAreInRange) {
    MeshData mesh = triangle;
    mesh.corners[1] = 3;
    const std::string message = "a face's indices must be below the number of what they name";
    expectProblem(check(mesh), "scene.index-out-of-range", message, 0);
    mesh = triangle;
    mesh.normals = {{0, 0, 1}};
    mesh.cornerNormals = {0, 0, 1};
    expectProblem(check(mesh), "scene.index-out-of-range", message, 0);
}

TEST(CheckMesh, SmoothFacesAreTriangles) {
    MeshData mesh = oneFace({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
    mesh.normals = {{0, 0, 1}};
    mesh.cornerNormals = {0, 0, 0, 0};
    expectProblem(check(mesh), "scene.face-not-triangle",
                  "a face of a mesh with normals must be a triangle, got 4 vertices", 0);
}

TEST(CheckMesh, NumbersAreFinite) {
    MeshData mesh = triangle;
    mesh.vertices[0].x = test::infinity;
    expectProblem(check(mesh), "scene.not-finite", "the vertices and normals of a mesh must be finite", -1);
}

TEST(CheckMesh, TellsAboutTheFirstFacesOnly) {
    MeshData mesh = triangle;
    mesh.faceStarts.assign(1001, 3); // a thousand faces; all but the first have no corner
    mesh.faceStarts[0] = 0;
    const Problems problems = check(mesh);
    EXPECT_EQ(problems.size(), 10U);
    EXPECT_EQ(problems[0].argument, 1);
}

} // namespace
} // namespace yarte
