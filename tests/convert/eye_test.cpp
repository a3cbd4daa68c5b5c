// Whether the camera starts inside.
#include "convert/povray/eye.h"

#include <gtest/gtest.h>

namespace yarte::convert::povray {
namespace {

/// A unit cube from the origin, outward faces.
MeshData cube() {
    MeshData mesh;
    mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
    mesh.corners = {0, 3, 2, 1, 4, 5, 6, 7, 0, 1, 5, 4, 3, 7, 6, 2, 0, 4, 7, 3, 1, 2, 6, 5};
    for (std::uint32_t start = 4; start <= 24; start += 4) mesh.faceStarts.push_back(start);
    return mesh;
}

TEST(Eye, IsInsideAClosedMesh) {
    const MeshData mesh = cube();
    ASSERT_TRUE(isClosed(mesh));
    EXPECT_TRUE(isInside(mesh, mesh.vertices, {0.5, 0.5, 0.5}));
    EXPECT_TRUE(isInside(mesh, mesh.vertices, {0.001, 0.999, 0.5}));
    EXPECT_FALSE(isInside(mesh, mesh.vertices, {-0.001, 0.5, 0.5}));
    EXPECT_FALSE(isInside(mesh, mesh.vertices, {3, 0.5, 0.5}));
}

TEST(Eye, IsInsideAClosedMeshThatIsInsideOut) {
    MeshData mesh = cube();
    for (Vec3& v : mesh.vertices) v.x = -v.x;
    EXPECT_TRUE(isInside(mesh, mesh.vertices, {-0.5, 0.5, 0.5}));
}

TEST(Eye, IsNeverInsideAnOpenMesh) {
    MeshData mesh = cube();
    mesh.faceStarts.pop_back();
    mesh.corners.resize(20);
    EXPECT_FALSE(isClosed(mesh));
    EXPECT_FALSE(isInside(mesh, mesh.vertices, {0.5, 0.5, 0.5}));
}

TEST(Eye, IsInsideAClosedMeshWithAConcaveFace) {
    MeshData mesh; // an arrowhead of depth 1; its notch is at (0, 0.2)
    mesh.vertices = {{-1, -1, 0}, {0, 0.2, 0}, {1, -1, 0}, {0, 1, 0},
                     {-1, -1, 1}, {0, 0.2, 1}, {1, -1, 1}, {0, 1, 1}};
    mesh.corners = {3, 2, 1, 0, 4, 5, 6, 7, 0, 1, 5, 4, 1, 2, 6, 5, 2, 3, 7, 6, 3, 0, 4, 7};
    for (std::uint32_t start = 4; start <= 24; start += 4) mesh.faceStarts.push_back(start);
    ASSERT_TRUE(isClosed(mesh));
    EXPECT_TRUE(isInside(mesh, mesh.vertices, {0, 0.6, 0.5}));
    EXPECT_FALSE(isInside(mesh, mesh.vertices, {0, -0.2, 0.5})); // in the notch
}

TEST(Eye, IsTakenToBeInsideBehindADisc) {
    const Body disc{Disc{{0, 1, 0}, 2}, {}, {}, {}};
    EXPECT_TRUE(wouldHoldEye(disc, {5, 0.5, 5}));
    EXPECT_FALSE(wouldHoldEye(disc, {5, 1.5, 5}));
    const Body turned{Disc{{0, 1, 0}, 2}, {}, Referential{{1, 0, 0}, {0, -1, 0}, {}}, {}};
    EXPECT_FALSE(wouldHoldEye(turned, {5, 0.5, 5}));
}

TEST(Eye, IsTakenToBeInsideAnOpenConeBetweenItsRims) {
    const Body cone{TruncatedCone{{0, 0, 0}, 2, 4, 2}, {}, {}, {}};
    EXPECT_TRUE(wouldHoldEye(cone, {1.4, 1, 0}));
    EXPECT_FALSE(wouldHoldEye(cone, {1.6, 1, 0})); // the radius there is 1.5
    EXPECT_FALSE(wouldHoldEye(cone, {0, 2.1, 0}));
    EXPECT_FALSE(wouldHoldEye(cone, {0, -0.1, 0}));
}

TEST(Eye, IsTakenToBeInsideAnOpenCylinder) {
    const Body tube{OpenCylinder{{0, 0, 0}, 2, 3}, {}, Referential{{1, 0, 0}, {0, 0, 1}, {}}, {}};
    EXPECT_TRUE(wouldHoldEye(tube, {1.9, 0, 1}));
    EXPECT_FALSE(wouldHoldEye(tube, {1.9, 1, 1}));
    EXPECT_FALSE(wouldHoldEye(tube, {0, 0, 3.1}));
    EXPECT_FALSE(wouldHoldEye(tube, {0, 0, -0.1}));
}

TEST(Eye, IsNotConcernedByOtherShapes) {
    EXPECT_FALSE(wouldHoldEye({Sphere{{0, 0, 0}, 2}, {}, {}, {}}, {0, 0, 0}));
    EXPECT_FALSE(wouldHoldEye({Cone{{0, 0, 0}, 2, 2}, {}, {}, {}}, {0, 1, 0}));
    EXPECT_FALSE(wouldHoldEye({Cylinder{{0, 0, 0}, 2, 2}, {}, {}, {}}, {0, 1, 0}));
    EXPECT_FALSE(wouldHoldEye({Plane{{0, 1, 0}, 2}, {}, {}, {}}, {0, 1, 0}));
}

} // namespace
} // namespace yarte::convert::povray
