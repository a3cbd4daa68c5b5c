#include "convert/povray/sdl/build_round.h"

#include "convert/closed_mesh.h"
#include "convert/povray/sdl/round_mesh.h"
#include "convert/povray/sdl/stretch.h"
#include "tests/convert/povray/sdl/support.h"
#include "yarte/scene/referential.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

namespace yarte::convert::povray::sdl::test {
namespace {

const Tolerance byDefault;

template <class S>
const S& shapeOf(const Built& built) {
    return std::get<S>(std::get<Shape>(built.what));
}

void expectNear(Vec3 a, Vec3 b, double tolerance = 1e-9) { EXPECT_LE(length(a - b), tolerance); }

/// Points within the triangles and polygons of a mesh.
std::vector<Vec3> pointsOn(const MeshData& data) {
    std::vector<Vec3> points;
    for (std::size_t f = 0; f < data.faceCount(); ++f) {
        const auto face = data.face(f);
        const Vec3 a = data.vertices[face[0]], b = data.vertices[face[1]], c = data.vertices[face[2]];
        for (const double s : {0.0, 0.3, 0.5, 1 / 3.0})
            for (const double t : {0.0, 0.2, 0.5, 1 / 3.0}) points.push_back(a + (b - a) * s + (c - a) * t);
    }
    return points;
}

double volumeOf(const MeshData& data) {
    double sixfold = 0;
    for (std::size_t f = 0; f < data.faceCount(); ++f) {
        const auto face = data.face(f);
        for (std::size_t i = 1; i + 1 < face.size(); ++i)
            sixfold += dot(data.vertices[face[0]], cross(data.vertices[face[i]], data.vertices[face[i + 1]]));
    }
    return sixfold / 6;
}

void expectNormalsInFront(const MeshData& data) {
    for (std::size_t f = 0; f < data.faceCount(); ++f) {
        const auto face = data.face(f);
        const Vec3 a = data.vertices[face[0]];
        const Vec3 n = cross(data.vertices[face[1]] - a, data.vertices[face[2]] - a);
        for (const std::uint32_t i : data.faceNormals(f)) {
            EXPECT_NEAR(length(data.normals[i]), 1, 1e-6);
            ASSERT_GT(dot(n, data.normals[i]), 0) << f;
        }
    }
}

/// Undone, every point of the mesh is within the bound of the true surface, which is `distance` away there;
/// with 1 / the least stretch a bound in the world becomes one before the map.
void expectWithinBound(const Built& built, const Affine& a, const std::function<double(Vec3)>& distance) {
    const MeshData& data = std::get<MeshData>(built.what);
    const Affine back = *inverse(a);
    double worst = 0;
    for (const Vec3 p : pointsOn(data)) worst = std::max(worst, distance(mapPoint(back, p)));
    EXPECT_GT(built.deviation, 0);
    EXPECT_LE(worst, built.deviation / largestStretch(a) * 1.0001);
    EXPECT_GE(worst, built.deviation / largestStretch(a) * 0.2); // the bound is not idle
    expectNormalsInFront(data);
}

TEST(Round, LargestStretchIsOne) {
    Random random(4);
    for (int i = 0; i < 50; ++i) {
        const Affine a = random.affine();
        double most = 0;
        for (int j = 0; j < 3000; ++j) most = std::max(most, length(mapDirection(a, unit(random.inCube(1)))));
        EXPECT_GE(largestStretch(a), most);
        EXPECT_LE(largestStretch(a), most * 1.08); // 3^(1/16) = 1.071
    }
    EXPECT_EQ(largestStretch(scaling({3, -3, 3})), 3);
}

TEST(Round, SpheresStaySpheresUnderSimilarities) {
    const SphereShape sphere{{1, 2, 3}, -2};
    Random random(5);
    for (int i = 0; i < 20; ++i) {
        const Affine a = random.similarity();
        const Built built = build(sphere, a, byDefault);
        expectNear(shapeOf<Sphere>(built).centre, mapPoint(a, sphere.centre));
        EXPECT_NEAR(shapeOf<Sphere>(built).radius, 2 * similarityOf(a).scale, 1e-12);
        EXPECT_EQ(built.deviation, 0);
    }
    EXPECT_EQ(shapeOf<Sphere>(build(sphere, scaling({-3, 3, 3}), byDefault)).radius, 6);
    EXPECT_FALSE(build(SphereShape{{}, 0}, {}, byDefault).why.empty());
}

TEST(Round, EllipsoidsAreMeshesWithinTheirBound) {
    Random random(6);
    for (int i = 0; i < 5; ++i) {
        const Affine a = random.affine();
        const Built built = build(SphereShape{{1, 2, 3}, 2}, a, byDefault);
        EXPECT_LE(built.deviation, 2 * largestStretch(a) * 1.0001e-3);
        expectWithinBound(built, a, [](Vec3 p) { return std::abs(length(p - Vec3{1, 2, 3}) - 2); });
        EXPECT_TRUE(isClosed(std::get<MeshData>(built.what)));
        EXPECT_NEAR(volumeOf(std::get<MeshData>(built.what)),
                    4 * std::numbers::pi / 3 * 8 * std::abs(determinant(a)), 0.2 * std::abs(determinant(a)));
    }
    // A map that is nearly a similarity leaves a sphere, which is nearer than triangles would be.
    const Built nearly = build(SphereShape{{}, 1}, scaling({1, 1, 1 + 1e-5}), byDefault);
    EXPECT_NEAR(shapeOf<Sphere>(nearly).radius, 1, 1e-5);
    EXPECT_GE(nearly.deviation, 6e-6);
    EXPECT_LE(nearly.deviation, 2e-5);
}

TEST(Round, ChordErrorIsInWorldUnits) {
    const Affine a = scaling({1, 2, 40});
    const Built built = build(SphereShape{{}, 1}, a, {0.01});
    EXPECT_LE(built.deviation, 0.0101);
    EXPECT_GT(built.deviation, 0.005);
}

TEST(Round, ConesAndCylindersByTheirRadii) {
    EXPECT_EQ(shapeOf<Cylinder>(build(ConeShape{{0, 1, 0}, 2, {0, 4, 0}, 2, false}, {}, byDefault)),
              (Cylinder{{0, 1, 0}, 2, 3}));
    EXPECT_EQ(shapeOf<OpenCylinder>(build(ConeShape{{0, 1, 0}, 2, {0, 4, 0}, 2, true}, {}, byDefault)),
              (OpenCylinder{{0, 1, 0}, 2, 3}));
    EXPECT_EQ(shapeOf<Cone>(build(ConeShape{{0, 1, 0}, 2, {0, 4, 0}, 0, false}, {}, byDefault)),
              (Cone{{0, 1, 0}, 2, 3}));
    EXPECT_EQ(shapeOf<TruncatedCone>(build(ConeShape{{0, 1, 0}, 2, {0, 4, 0}, 0, true}, {}, byDefault)),
              (TruncatedCone{{0, 1, 0}, 2, 3, 3}));
    EXPECT_EQ(shapeOf<TruncatedCone>(build(ConeShape{{0, 1, 0}, 2, {0, 4, 0}, 1, true}, {}, byDefault)),
              (TruncatedCone{{0, 1, 0}, 2, 6, 3}));
    EXPECT_EQ(shapeOf<Frustum>(build(ConeShape{{0, 1, 0}, 1, {0, 4, 0}, 2, false}, {}, byDefault)),
              (Frustum{{0, 1, 0}, 1, 2, 3}));
    // The tip or the narrow end first: turned upside down.
    const Built cone = build(ConeShape{{0, 1, 0}, 0, {0, 4, 0}, 2, false}, {}, byDefault);
    EXPECT_EQ(shapeOf<Cone>(cone), (Cone{{0, 4, 0}, 2, 3}));
    EXPECT_EQ(cone.referential->y, (Vec3{0, -1, 0}));
    EXPECT_EQ(shapeOf<TruncatedCone>(build(ConeShape{{0, 1, 0}, 1, {0, 4, 0}, 2, true}, {}, byDefault)),
              (TruncatedCone{{0, 4, 0}, 2, 6, 3}));
    for (const ConeShape& degenerate :
         {ConeShape{{}, 1, {}, 2}, ConeShape{{}, 0, {0, 1, 0}, 0}, ConeShape{{}, 1, {0, 1, 0}, -1}})
        EXPECT_FALSE(build(degenerate, {}, byDefault).why.empty());
}

TEST(Round, ConesStayRoundWhereTheirCirclesDo) {
    const ConeShape cone{{1, 1, 1}, 2, {1, 4, 1}, 1, false};
    EXPECT_EQ(shapeOf<Frustum>(build(cone, scaling({3, 5, -3}), byDefault)), (Frustum{{3, 5, -3}, 6, 3, 15}));
    EXPECT_TRUE(std::holds_alternative<MeshData>(build(cone, scaling({3, 5, 4}), byDefault).what));
    const Affine shear{{1, 0, 0}, {0.5, 1, 0}, {0, 0, 1}, {}}; // along the base
    EXPECT_TRUE(std::holds_alternative<MeshData>(build(cone, shear, byDefault).what));
    Random random(7);
    for (int i = 0; i < 20; ++i) {
        const Affine a = then(scaling({3, 5, -3}), random.similarity());
        const Built built = build(cone, a, byDefault);
        const Frustum& f = shapeOf<Frustum>(built);
        const Frame axes = resolveReferential(*built.referential);
        expectNear(f.centre, mapPoint(a, cone.a));
        expectNear(f.centre + axes.y * f.height, mapPoint(a, cone.b));
        EXPECT_NEAR(f.baseRadius, 6 * length(mapDirection(a, {1, 0, 0})) / 3, 1e-9);
        EXPECT_EQ(built.deviation, 0);
    }
}

TEST(Round, BentConesAreMeshesWithinTheirBound) {
    Random random(8);
    for (const auto& [top, isOpen] : {std::pair{1.0, false}, {0.0, false}, {2.0, true}, {3.0, false}}) {
        const ConeShape cone{{1, 1, 1}, 2, {1, 4, 1}, top, isOpen};
        const Affine a = random.affine();
        const Built built = build(cone, a, byDefault);
        const double slope = (top - 2) / 3, lean = 1 / std::hypot(1, slope);
        expectWithinBound(built, a, [&](Vec3 p) {
            const double y = p.y - 1, wall = std::abs(std::hypot(p.x - 1, p.z - 1) - (2 + slope * y)) * lean;
            return isOpen ? wall : std::min({wall, std::abs(y), std::abs(y - 3)});
        });
        EXPECT_EQ(isClosed(std::get<MeshData>(built.what)), !isOpen);
        if (!isOpen) {
            const double volume = std::numbers::pi * (4 + 2 * top + top * top);
            EXPECT_NEAR(volumeOf(std::get<MeshData>(built.what)) / std::abs(determinant(a)), volume,
                        volume * 0.01);
        }
    }
}

TEST(Round, BoxesKeepRightAnglesOrBecomeMeshes) {
    const BoxShape box{{3, 1, 5}, {1, 2, 3}};
    EXPECT_EQ(shapeOf<Box>(build(box, {})), (Box{{2, 1.5, 4}, {2, 1, 2}}));
    const Built scaled = build(box, scaling({2, -3, 1}));
    EXPECT_EQ(shapeOf<Box>(scaled), (Box{{4, -4.5, 4}, {4, 3, 2}}));
    EXPECT_FALSE(scaled.referential);
    Random random(9);
    for (int i = 0; i < 20; ++i) {
        const Affine turn = then(scaling({2, -3, 1}), random.similarity());
        const Built built = build(box, turn);
        const Box& b = shapeOf<Box>(built);
        const Frame axes = resolveReferential(built.referential.value());
        expectNear(b.centre, mapPoint(turn, {2, 1.5, 4}));
        expectNear(axes.x * b.sides.x, mapDirection(turn, {2, 0, 0}));
        expectNear(axes.y * b.sides.y, mapDirection(turn, {0, 1, 0}));

        const Affine bent = random.affine();
        const Built mesh = build(box, bent);
        const MeshData& data = std::get<MeshData>(mesh.what);
        EXPECT_EQ(mesh.deviation, 0);
        EXPECT_TRUE(isClosed(data));
        EXPECT_NEAR(volumeOf(data), 4 * std::abs(determinant(bent)), 1e-9);
        expectNear(data.vertices[7], mapPoint(bent, {3, 2, 5}));
    }
    // POV-Ray shows a box without thickness.
    EXPECT_EQ(shapeOf<Polygon>(build(BoxShape{{0, 1, 0}, {2, 1, 3}}, {})).vertices.size(), 4U);
    EXPECT_FALSE(build(BoxShape{{0, 1, 0}, {2, 1, 0}}, {}).why.empty());
}

TEST(Round, DiscsFaceTheirNormal) {
    EXPECT_EQ(shapeOf<Disc>(build(DiscShape{{1, 2, 3}, {0, 7, 0}, 4, 0}, {}, byDefault)),
              (Disc{{1, 2, 3}, 4}));
    Random random(10);
    for (int i = 0; i < 20; ++i) {
        const DiscShape disc{{1, 2, 3}, random.inCube(1), 4, 0};
        const Affine a = then(random.similarity(), scaling({-1, 1, 1}));
        const Built built = build(disc, a, byDefault);
        const Frame axes = resolveReferential(built.referential.value());
        expectNear(axes.y, unit(mapNormal(a, disc.normal)));
        EXPECT_NEAR(shapeOf<Disc>(built).radius, 4 * similarityOf(a).scale, 1e-9);

        const Affine bent = random.affine();
        for (const double hole : {0.0, 1.5}) {
            const Built mesh = build(DiscShape{disc.centre, disc.normal, 4, hole}, bent, byDefault);
            const MeshData& data = std::get<MeshData>(mesh.what);
            const Vec3 a0 = data.vertices[data.corners[0]], n = unit(mapNormal(bent, disc.normal));
            EXPECT_GT(dot(cross(data.vertices[data.corners[1]] - a0, data.vertices[data.corners[2]] - a0), n),
                      0);
            for (const Vec3 p : pointsOn(data)) EXPECT_NEAR(dot(p - a0, n), 0, 1e-9);
        }
    }
    // One that is scaled along its axis alone stays.
    EXPECT_EQ(shapeOf<Disc>(build(DiscShape{{}, {0, 1, 0}, 4, 0}, scaling({2, 9, 2}), byDefault)),
              (Disc{{}, 8}));
}

TEST(Round, ToriAreMeshesWithinTheirBound) {
    Random random(11);
    for (int i = 0; i < 3; ++i) {
        const Affine a = random.affine();
        const Built built = build(TorusShape{3, 1}, a, byDefault);
        expectWithinBound(built, a,
                          [](Vec3 p) { return std::abs(std::hypot(std::hypot(p.x, p.z) - 3, p.y) - 1); });
        EXPECT_TRUE(isClosed(std::get<MeshData>(built.what)));
        const double volume = 2 * std::numbers::pi * std::numbers::pi * 3;
        EXPECT_NEAR(volumeOf(std::get<MeshData>(built.what)) / std::abs(determinant(a)), volume,
                    volume * 0.01);
    }
}

TEST(Round, PlanesMoveWithTheirPoints) {
    const PlaneShape plane{{0, 0, -2}, 2}; // measured: the plane z = -2
    EXPECT_EQ(shapeOf<Plane>(build(plane, {})), (Plane{{0, 0, -2}, 2}));
    Random random(12);
    for (int i = 0; i < 50; ++i) {
        const Affine a = random.affine();
        const Built built = build(plane, a);
        const Plane& p = shapeOf<Plane>(built);
        const Vec3 on{random.between(-5, 5), random.between(-5, 5), -2};
        EXPECT_NEAR(dot(unit(p.normal), mapPoint(a, on)), p.distance, 1e-9);
        EXPECT_LT(dot(unit(p.normal), mapPoint(a, on + Vec3{0, 0, 1})), p.distance); // its inside
    }
}

} // namespace
} // namespace yarte::convert::povray::sdl::test
