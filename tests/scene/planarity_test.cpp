#include "yarte/scene/planarity.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace yarte {
namespace {

/// A square of diagonal 2 whose corners alternate in height: each lies `z` off the plane.
std::vector<Vec3> saddle(double z, double scale = 1, Vec3 at = {}) {
    std::vector<Vec3> vertices{{1, 0, z}, {0, 1, -z}, {-1, 0, z}, {0, -1, -z}};
    for (Vec3& v : vertices) v = v * scale + at;
    return vertices;
}

TEST(Planarity, IsTheDistanceOverTheSize) {
    for (const double z : {1e-9, 1e-3, 0.1})
        EXPECT_NEAR(planarity(saddle(z))->error, z / (2 * std::sqrt(1 + z * z)), 1e-15) << z;
    EXPECT_EQ(planarity(saddle(0))->error, 0);
}

TEST(Planarity, DoesNotDependOnScaleOrPlace) {
    const double expected = planarity(saddle(0.01))->error;
    for (const double scale : {1e-310, 1e-200, 1e-3, 1e200, 1e307})
        EXPECT_NEAR(planarity(saddle(0.01, scale))->error, expected, 1e-12) << scale;
    EXPECT_NEAR(planarity(saddle(0.01, 1, {1e6, -1e6, 1e6}))->error, expected, 1e-9);
}

TEST(Planarity, NamesTheFarthestVertex) {
    std::vector<Vec3> vertices{{10, 0, 0}, {0, 10, 0}, {-10, 0, 0}, {-7, -7, 0}, {0, -10, 0.5}};
    EXPECT_EQ(planarity(vertices)->vertex, 4U);
}

TEST(Planarity, ConcaveFacesArePlanarToo) {
    EXPECT_LT(planarity(std::vector<Vec3>{{0, 0, 1}, {4, 0, 1}, {1, 1, 1}, {0, 4, 1}})->error, 1e-15);
}

TEST(Planarity, NothingWithoutArea) {
    EXPECT_FALSE(planarity(std::vector<Vec3>{}));
    EXPECT_FALSE(planarity(std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}}));
    EXPECT_FALSE(planarity(std::vector<Vec3>{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}));
    EXPECT_FALSE(planarity(std::vector<Vec3>{{5, 5, 5}, {5, 5, 5}, {5, 5, 5}}));
    EXPECT_FALSE(planarity(std::vector<Vec3>{{0, 0, 0}, {0.1, 0.2, 0.3}, {0.3, 0.6, 0.9}}));
    EXPECT_TRUE(planarity(std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1e-9, 0}})); // thin, but there
}

} // namespace
} // namespace yarte
