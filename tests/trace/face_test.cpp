#include "yarte/trace/face.h"

#include "tests/support/scenes.h"

#include <gtest/gtest.h>

#include <numbers>

using namespace yarte;
using namespace yarte::trace;

namespace {

FaceTable tableOf(std::vector<Vec3> vertices, const std::vector<std::vector<std::uint32_t>>& faces) {
    FaceTable table;
    table.vertices = std::move(vertices);
    for (const auto& corners : faces) {
        table.faces.push_back({static_cast<std::uint32_t>(table.corners.size()),
                               static_cast<std::uint32_t>(corners.size()), Face::noPlane, false});
        table.corners.insert(table.corners.end(), corners.begin(), corners.end());
    }
    return table;
}

int hits(const FaceTable& table, const Ray& ray) {
    int count = 0;
    for (const Face& face : table.faces) count += crossings(FaceShape{table, face}, ray).count;
    return count;
}

/// A jittered n x n grid of triangles over [-1, 1]^2, bent out of the plane: neighbouring faces share edges
/// and vertices.
FaceTable bumpyGrid(int n, unsigned seed) {
    test::Random random(seed);
    std::vector<Vec3> vertices;
    for (int y = 0; y <= n; ++y)
        for (int x = 0; x <= n; ++x) {
            const bool rim = x == 0 || y == 0 || x == n || y == n;
            const double jitter = rim ? 0 : 0.3 / n;
            vertices.push_back({2.0 * x / n - 1 + random.between(-jitter, jitter),
                                2.0 * y / n - 1 + random.between(-jitter, jitter),
                                random.between(-0.02, 0.02)});
        }
    std::vector<std::vector<std::uint32_t>> faces;
    const auto at = [n](int x, int y) { return static_cast<std::uint32_t>(y * (n + 1) + x); };
    for (int y = 0; y < n; ++y)
        for (int x = 0; x < n; ++x) {
            faces.push_back({at(x, y), at(x + 1, y), at(x + 1, y + 1)});
            faces.push_back({at(x, y), at(x + 1, y + 1), at(x, y + 1)});
        }
    return tableOf(vertices, faces);
}

TEST(Face, RaysAtSharedEdgesAndVerticesMeetExactlyOneFace) {
    const FaceTable grid = bumpyGrid(8, 1);
    test::Random random(2);
    int checked = 0;
    for (const Face& face : grid.faces) {
        const auto corners = grid.cornersOf(face);
        for (int k = 0; k < 300; ++k) {
            const Vec3 a = grid.vertices[corners[static_cast<std::size_t>(random.below(3))]];
            const Vec3 b = grid.vertices[corners[static_cast<std::size_t>(random.below(3))]];
            const Vec3 target = a + random.between(0, 1) * (b - a);
            if (std::abs(target.x) > 0.99 || std::abs(target.y) > 0.99) continue;
            const Vec3 origin{random.between(-1, 1), random.between(-1, 1), random.between(3, 1000)};
            EXPECT_EQ(hits(grid, {origin, normalised(target - origin), {}}), 1);
            // Exactly down the z axis, through the vertex itself: no rounding in the shear.
            const bool isInner = std::abs(a.x) < 1 && std::abs(a.y) < 1;
            if (isInner) {
                EXPECT_EQ(hits(grid, {{a.x, a.y, 5}, {0, 0, -1}, {}}), 1);
            }
            ++checked;
        }
    }
    EXPECT_GT(checked, 10000);
}

TEST(Face, ConcavePolygonIsFilledEvenOdd) {
    // A pentagram crosses itself: its middle is counted twice, so it is a hole.
    std::vector<Vec3> star;
    for (int i = 0; i < 5; ++i)
        star.push_back(
            {std::cos(0.3 + i * 4 * std::numbers::pi / 5), std::sin(0.3 + i * 4 * std::numbers::pi / 5), 0});
    const FaceTable table = tableOf(star, {{0, 1, 2, 3, 4}});
    const auto isHit = [&](double x, double y) { return hits(table, {{x, y, 1}, {0, 0, -1}, {}}) == 1; };
    EXPECT_FALSE(isHit(0, 0));
    EXPECT_TRUE(isHit(0.8 * star[0].x, 0.8 * star[0].y));    // in a point of the star
    EXPECT_FALSE(isHit(-0.8 * star[0].x, -0.8 * star[0].y)); // between two points
}

TEST(Face, LShapeIsInsideWhereTheLIs) {
    const FaceTable table =
        tableOf({{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}}, {{0, 1, 2, 3, 4, 5}});
    test::Random random(5);
    for (int i = 0; i < 10000; ++i) {
        const double x = random.between(-0.5, 2.5), y = random.between(-0.5, 2.5);
        const bool inL = x > 0 && y > 0 && x < 2 && y < 2 && (x < 1 || y < 1);
        EXPECT_EQ(hits(table, {{x, y, 3}, {0, 0, -1}, {}}), inL ? 1 : 0) << x << ' ' << y;
    }
    EXPECT_EQ(planeOf(table, table.faces[0]).normal, (Vec3{0, 0, 1}));
}

TEST(Face, RaysAHairBesideAnEdgeAreToldApart) {
    // The edge from (0, 0) to (1, 1 + e), and points on its one side or the other by less than products in
    // doubles can tell: (1 + e)(1 - e) = 1 - e^2.
    const double e = 0x1p-30;
    const FaceTable table = tableOf({{0, 0, 0}, {1, 1 + e, 0}, {0, 1, 0}}, {{0, 1, 2}});
    const auto isHit = [&](double x, double y) { return hits(table, {{x, y, 1}, {0, 0, -1}, {}}) == 1; };
    EXPECT_TRUE(isHit((1 - e) / 2, 0.5));                             // x (1 + e) = (1 - e^2) / 2 < y
    EXPECT_FALSE(isHit(std::nextafter((1 - e) / 2, 1) + e * e, 0.5)); // above it by an ulp
    EXPECT_TRUE(isHit(0.5 - 0x1p-31 + 0x1p-60 - 0x1p-53, 0.5));
}

TEST(Face, SmoothNormalIsBarycentric) {
    FaceTable table = tableOf({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}, {{0, 1, 2}});
    table.normals = {normalised({1, 0, 3}), normalised({0, 1, 3}), normalised({-1, -1, 3})};
    table.cornerNormals = {0, 1, 2};
    table.faces[0].isSmooth = true;
    const FaceShape face{table, table.faces[0]};
    const Vec3 expected =
        normalised(0.5 * table.normals[0] + 0.25 * table.normals[1] + 0.25 * table.normals[2]);
    EXPECT_LT(length(outwardNormal(face, {1, 1, 0}, 0) - expected), 1e-15);
    EXPECT_LT(length(outwardNormal(face, {0, 4, 0}, 0) - table.normals[2]), 1e-15);
}

} // namespace
