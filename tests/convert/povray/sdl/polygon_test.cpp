#include "convert/povray/sdl/build_polygon.h"

#include "convert/povray/sdl/stretch.h"
#include "tests/convert/povray/sdl/support.h"
#include "yarte/scene/check.h"

#include <gtest/gtest.h>

namespace yarte::convert::povray::sdl::test {
namespace {

const std::vector<Vec3> square{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}};

const std::vector<Vec3>& outlineOf(const Built& built) {
    return std::get<Polygon>(std::get<Shape>(built.what)).vertices;
}

Vec3 areaVector(const std::vector<Vec3>& v) {
    Vec3 sum;
    for (std::size_t i = 0; i < v.size(); ++i) sum += cross(v[i], v[(i + 1) % v.size()]);
    return sum / 2;
}

/// Crossings of a ray in the plane z = 0 from `p` along +x: odd inside.
bool isInside(const std::vector<Vec3>& v, Vec3 p) {
    bool inside = false;
    for (std::size_t i = 0; i < v.size(); ++i) {
        const Vec3 a = v[i], b = v[(i + 1) % v.size()];
        if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y))
            inside = !inside;
    }
    return inside;
}

TEST(SdlPolygon, StaysAsItIs) {
    const Built built = build(PolygonShape{{square}}, {});
    EXPECT_EQ(outlineOf(built), square);
    EXPECT_EQ(built.deviation, 0);
}

TEST(SdlPolygon, FrontIsThatOfTheFirstThreeVertices) {
    Random random(30);
    // A dart whose first turn is reflex: Newell's normal is the opposite.
    const std::vector<Vec3> dart{{0, 0, 0}, {1, 1, 0}, {0, 4, 0}, {-4, -4, 0}, {5, 0, 0}};
    for (const auto& contour : {square, dart})
        for (int i = 0; i < 20; ++i) {
            const Affine a = random.affine();
            const Vec3 front = cross(contour[1] - contour[0], contour[2] - contour[0]);
            EXPECT_GT(dot(areaVector(outlineOf(build(PolygonShape{{contour}}, a))), mapNormal(a, front)), 0);
        }
}

TEST(SdlPolygon, ContoursAreHolesByEvenOdd) {
    const std::vector<Vec3> hole{{1, 1, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, 0}},
        island{{6, 0, 0}, {7, 0, 0}, {7, 1, 0}};
    const Built built = build(PolygonShape{{square, hole, island}}, {});
    const auto& outline = outlineOf(built);
    EXPECT_TRUE(check(std::get<Shape>(built.what)).empty());
    EXPECT_TRUE(isInside(outline, {0.5, 0.51, 0}));
    EXPECT_FALSE(isInside(outline, {1.5, 1.51, 0}));
    EXPECT_TRUE(isInside(outline, {3.5, 1.51, 0}));
    EXPECT_TRUE(isInside(outline, {6.9, 0.51, 0}));
    EXPECT_FALSE(isInside(outline, {5.5, 0.51, 0}));
}

TEST(SdlPolygon, IsDroppedWherePovrayDropsIt) {
    std::vector<Vec3> bent = square;
    bent[2].z = 1e-9;
    EXPECT_NE(build(PolygonShape{{bent}}, {}).why.find("POV-Ray"), std::string::npos);
    bent[2].z = 0.5e-10;
    EXPECT_TRUE(build(PolygonShape{{bent}}, {}).why.empty());
    EXPECT_FALSE(build(PolygonShape{{{{0, 0, 0}, {1, 1, 0}, {2, 2, 0}}}}, {}).why.empty());
    EXPECT_FALSE(build(PolygonShape{}, {}).why.empty());
}

} // namespace
} // namespace yarte::convert::povray::sdl::test
