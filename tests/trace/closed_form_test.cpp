// Where lines cross shapes, as known in closed form.
#include "yarte/trace/box.h"
#include "yarte/trace/cone.h"
#include "yarte/trace/disc.h"
#include "yarte/trace/frustum.h"
#include "yarte/trace/plane.h"
#include "yarte/trace/sphere.h"
#include "yarte/trace/truncated_cone.h"

#include <gtest/gtest.h>

using namespace yarte;
using namespace yarte::trace;

namespace {

TEST(Sphere, ClosedForm) {
    const trace::Sphere s(yarte::Sphere{{0, 0, 0}, 5});
    const auto c = crossings(s, {{0, 3, 100}, {0, 0, -1}, {}});
    ASSERT_EQ(c.count, 2);
    EXPECT_EQ(c.list[0].t, 96);
    EXPECT_EQ(c.list[1].t, 104);
    EXPECT_EQ(crossings(s, {{0, 5.0000001, 100}, {0, 0, -1}, {}}).count, 0);
}

TEST(Sphere, ASmallOneFarAwayKeepsItsDigits) {
    const trace::Sphere s(yarte::Sphere{{0, 0, 0}, 1e-3});
    const auto c = crossings(s, {{0, 6e-4, 1e6}, {0, 0, -1}, {}});
    ASSERT_EQ(c.count, 2);
    EXPECT_NEAR(c.list[0].t, 1e6 - 8e-4, 2e-10); // one ulp of t
    EXPECT_NEAR(c.list[1].t, 1e6 + 8e-4, 2e-10);
}

TEST(Cone, ClosedForm) {
    const trace::Cone cone(yarte::Cone{{0, 0, 0}, 3, 4}, Frame{});
    const auto across = crossings(cone, {{-10, 2, 0}, {1, 0, 0}, {}}); // half way up the radius is 1.5
    ASSERT_EQ(across.count, 2);
    EXPECT_NEAR(across.list[0].t, 8.5, 1e-15);
    EXPECT_NEAR(across.list[1].t, 11.5, 1e-15);
    const auto down = crossings(cone, {{1.5, 10, 0}, {0, -1, 0}, {}});
    ASSERT_EQ(down.count, 2);
    EXPECT_NEAR(down.list[0].t, 8, 1e-15);
    EXPECT_EQ(down.list[1].t, 10);
    EXPECT_EQ(down.list[1].part, 1);
    EXPECT_EQ(outwardNormal(cone, {1.5, 0, 0}, 1), (Vec3{0, -1, 0}));
    const Vec3 n = outwardNormal(cone, {1.5, 2, 0}, 0);
    EXPECT_NEAR(n.x, 0.8, 1e-15);
    EXPECT_NEAR(n.y, 0.6, 1e-15);
}

TEST(Cone, ParallelToAGenerator) {
    // Slope 1: the direction (1, -1, 0)/sqrt(2) makes the quadratic's leading coefficient vanish.
    const trace::Cone cone(yarte::Cone{{0, 0, 0}, 1, 1}, Frame{});
    const double s = std::sqrt(0.5);
    const auto c = crossings(cone, {{-1, 1, 0}, {s, -s, 0}, {}});
    ASSERT_EQ(c.count, 2);
    EXPECT_NEAR(c.list[0].t, 0.5 / s, 1e-15); // meets x = y - 1 at (-1/2, 1/2)
    EXPECT_NEAR(c.list[1].t, 1 / s, 1e-15);   // and the base at the origin
    EXPECT_EQ(c.list[1].part, 1);
}

TEST(TruncatedCone, IsOpenAtBothEnds) {
    const trace::TruncatedCone cone(yarte::TruncatedCone{{0, 0, 0}, 2, 4, 1}, Frame{});
    EXPECT_EQ(crossings(cone, {{0.1, 10, 0}, {0, -1, 0}, {}}).count, 0);  // through both openings
    EXPECT_EQ(crossings(cone, {{1.75, 10, 0}, {0, -1, 0}, {}}).count, 1); // through the wall
    EXPECT_EQ(crossings(cone, {{-10, 0.5, 0}, {1, 0, 0}, {}}).count, 2);
    EXPECT_EQ(crossings(cone, {{-10, 1.01, 0}, {1, 0, 0}, {}}).count, 0); // above what is kept
}

TEST(OpenCylinder, IsOpenAtBothEnds) {
    const trace::TruncatedCone tube(yarte::OpenCylinder{{0, 0, 0}, 2, 4}, Frame{});
    EXPECT_EQ(crossings(tube, {{0.1, 10, 0}, {0, -1, 0}, {}}).count, 0); // along the axis
    EXPECT_EQ(crossings(tube, {{2, 10, 0}, {0, -1, 0}, {}}).count, 0);   // along the wall
    const auto across = crossings(tube, {{-10, 3, 1.2}, {1, 0, 0}, {}}); // half a chord is 1.6
    ASSERT_EQ(across.count, 2);
    EXPECT_EQ(across.list[0].t, 8.4);
    EXPECT_EQ(across.list[1].t, 11.6);
    EXPECT_EQ(crossings(tube, {{-10, 4.01, 0}, {1, 0, 0}, {}}).count, 0);
    const auto in =
        crossings(tube, {{0, 10, 0}, normalised({1, -4, 0}), {}}); // in from above, out through the wall
    ASSERT_EQ(in.count, 1);
    EXPECT_FALSE(in.list[0].entering);
    EXPECT_NEAR(in.list[0].t, 2 * std::sqrt(17.0), 1e-14);
    EXPECT_EQ(outwardNormal(tube, {0, 1, -2}, 0), (Vec3{0, 0, -1}));
}

TEST(Cylinder, ClosedForm) {
    const trace::Frustum c(yarte::Cylinder{{0, 0, 0}, 5, 4}, Frame{});
    const auto across = crossings(c, {{-10, 1, 3}, {1, 0, 0}, {}});
    ASSERT_EQ(across.count, 2);
    EXPECT_EQ(across.list[0].t, 6);
    EXPECT_EQ(across.list[1].t, 14);
    const auto down =
        crossings(c, {{3, 10, 4}, {0, -1, 0}, {}}); // along the wall itself: its rim counts as inside
    ASSERT_EQ(down.count, 2);
    EXPECT_EQ(down.list[0].t, 6);
    EXPECT_EQ(down.list[0].part, 2);
    EXPECT_EQ(down.list[1].t, 10);
    EXPECT_EQ(down.list[1].part, 1);
    EXPECT_EQ(crossings(c, {{3.0000001, 10, 4}, {0, -1, 0}, {}}).count, 0);
    EXPECT_EQ(crossings(c, {{3, -10, 4}, {0, 1, 0}, {}}).list[0].part, 1);
    EXPECT_EQ(outwardNormal(c, {3, 4, 4}, 2), (Vec3{0, 1, 0}));
    EXPECT_EQ(outwardNormal(c, {3, 0, 4}, 1), (Vec3{0, -1, 0}));
    const Vec3 n = outwardNormal(c, {3, 1, 4}, 0);
    EXPECT_NEAR(n.x, 0.6, 1e-15);
    EXPECT_EQ(n.y, 0);
    EXPECT_NEAR(n.z, 0.8, 1e-15);
}

TEST(Cylinder, GrazingLines) {
    const trace::Frustum c(yarte::Cylinder{{0, 0, 0}, 1, 4}, Frame{});
    const auto touching = crossings(c, {{-10, 2, 1}, {1, 0, 0}, {}}); // a tangent meets it twice in one point
    ASSERT_EQ(touching.count, 2);
    EXPECT_EQ(touching.list[0].t, 10);
    EXPECT_EQ(touching.list[1].t, 10);
    EXPECT_EQ(crossings(c, {{-10, 2, std::nextafter(1, 2)}, {1, 0, 0}, {}}).count, 0);
    // In the plane of a lid: inside, as a box's face is; beyond it: not.
    EXPECT_EQ(crossings(c, {{-10, 4, 0.5}, {1, 0, 0}, {}}).count, 2);
    EXPECT_EQ(crossings(c, {{-10, 0, 0.5}, {1, -0.0, 0}, {}}).count, 2);
    EXPECT_EQ(crossings(c, {{-10, std::nextafter(4, 5), 0.5}, {1, 0, 0}, {}}).count, 0);
    EXPECT_EQ(crossings(c, {{-10, -1e-300, 0.5}, {1, 0, 0}, {}}).count, 0);
}

TEST(Cylinder, LinesNextToItsAxis) {
    // So nearly parallel that the quadratic's coefficients are small, subnormal, or 0.
    const trace::Frustum c(yarte::Cylinder{{0, 0, 0}, 1, 4}, Frame{});
    for (const double lean : {1e-8, 1e-100, 1e-160, 1e-162, 1e-170, 1e-310, 0.0})
        for (const double x : {0.0, 0.5, -0.5}) {
            const auto list = crossings(c, {{x, 10, 0}, {lean, -1, 0}, {}});
            ASSERT_EQ(list.count, 2) << lean << ' ' << x;
            EXPECT_EQ(list.list[0].t, 6) << lean << ' ' << x;
            EXPECT_EQ(list.list[0].part, 2);
            EXPECT_EQ(list.list[1].t, 10) << lean << ' ' << x;
            EXPECT_EQ(list.list[1].part, 1);
            EXPECT_EQ(crossings(c, {{1.5, 10, 0}, {lean, -1, 0}, {}}).count, 0) << lean;
        }
}

TEST(Cylinder, AWireFarAwayKeepsItsDigits) {
    const trace::Frustum c(yarte::Cylinder{{0, -50, 0}, 1e-3, 100}, Frame{});
    const auto list = crossings(c, {{1e6, 0, 6e-4}, {-1, 0, 0}, {}});
    ASSERT_EQ(list.count, 2);
    EXPECT_NEAR(list.list[0].t, 1e6 - 8e-4, 2e-10); // one ulp of t
    EXPECT_NEAR(list.list[1].t, 1e6 + 8e-4, 2e-10);
}

TEST(Frustum, ClosedForm) {
    for (const bool isUpright : {true, false}) { // the larger disc below or above
        const double r = isUpright ? 3 : 1, top = isUpright ? 1 : 3;
        const trace::Frustum f(yarte::Frustum{{0, 0, 0}, r, top, 4}, Frame{});
        const auto across = crossings(f, {{-10, 2, 0}, {1, 0, 0}, {}}); // half way up the radius is 2
        ASSERT_EQ(across.count, 2);
        EXPECT_NEAR(across.list[0].t, 8, 1e-14);
        EXPECT_NEAR(across.list[1].t, 12, 1e-14);
        const auto down =
            crossings(f, {{2, 10, 0}, {0, -1, 0}, {}}); // one end through the wall, one through a lid
        ASSERT_EQ(down.count, 2);
        EXPECT_NEAR(down.list[0].t, isUpright ? 8 : 6, 1e-14);
        EXPECT_EQ(down.list[0].part, isUpright ? 0 : 2);
        EXPECT_NEAR(down.list[1].t, isUpright ? 10 : 8, 1e-14);
        EXPECT_EQ(down.list[1].part, isUpright ? 1 : 0);
        const Vec3 n = outwardNormal(f, {2, 2, 0}, 0);
        EXPECT_NEAR(n.x, 2 / std::sqrt(5.0), 1e-15);
        EXPECT_NEAR(n.y, (isUpright ? 1 : -1) / std::sqrt(5.0), 1e-15);
        EXPECT_EQ(crossings(f, {{-10, 5, 0}, {1, 0, 0}, {}}).count, 0);
        EXPECT_EQ(crossings(f, {{-10, -0.1, 0}, {1, 0, 0}, {}}).count, 0);
    }
}

TEST(Frustum, OtherNappeIsNotMet) {
    // The cone goes on to its apex at y = 6 and, mirrored, beyond.
    const trace::Frustum f(yarte::Frustum{{0, 0, 0}, 3, 1, 4}, Frame{});
    EXPECT_EQ(crossings(f, {{-10, 9, 0}, {1, 0, 0}, {}}).count, 0);
    const auto steep = crossings(f, {{0.1, 20, 0}, normalised({0.02, -1, 0}), {}});
    ASSERT_EQ(steep.count, 2);
    EXPECT_EQ(steep.list[0].part, 2);
    EXPECT_EQ(steep.list[1].part, 1);
}

TEST(Plane, ClosedForm) {
    const trace::Plane floor(yarte::Plane{{0, 2, 0}, -3}); // the normal's length does not count
    const auto down = crossings(floor, {{5, 4, 6}, {0, -1, 0}, {}});
    ASSERT_EQ(down.count, 1);
    EXPECT_EQ(down.list[0].t, 7);
    EXPECT_TRUE(down.list[0].entering);
    const auto up = crossings(floor, {{5, -5, 6}, {0, 1, 0}, {}});
    ASSERT_EQ(up.count, 1);
    EXPECT_EQ(up.list[0].t, 2);
    EXPECT_FALSE(up.list[0].entering);
    EXPECT_EQ(outwardNormal(floor, {}, 0), (Vec3{0, 1, 0}));
    EXPECT_EQ(heightAbove(floor, {7, 1, 8}), 4);

    const trace::Plane tilted(yarte::Plane{{3, 4, 0}, 5}); // through (3, 4, 0) and (25/3, 0, 0)
    const auto along = crossings(tilted, {{0, 0, 0}, {1, 0, 0}, {}});
    ASSERT_EQ(along.count, 1);
    EXPECT_NEAR(along.list[0].t, 25 / 3.0, 1e-14);
}

TEST(Plane, ParallelLinesDoNotMeetIt) {
    const trace::Plane floor(yarte::Plane{{0, 1, 0}, 1});
    EXPECT_EQ(crossings(floor, {{0, 5, 0}, {1, 0, 0}, {}}).count, 0);
    EXPECT_EQ(crossings(floor, {{0, 1, 0}, {1, 0, 0}, {}}).count, 0); // within
    EXPECT_EQ(crossings(floor, {{0, 1, 0}, {1, -0.0, 0}, {}}).count, 0);
    EXPECT_EQ(crossings(floor, {{0, 1e9, 0}, {1, -1e-310, 0}, {}}).count, 0); // beyond all numbers
    const auto far = crossings(floor, {{0, 3, 0}, {1, -1e-200, 0}, {}});
    ASSERT_EQ(far.count, 1);
    EXPECT_EQ(far.list[0].t, 2e200);
}

TEST(Plane, NormalsOfAnyLength) {
    for (const double size : {5e-324, 1e-300, 1e-5, 1.0, 1e5, 1e300, 1.7e308}) {
        const trace::Plane plane(yarte::Plane{{0, 0, -size}, 2});
        EXPECT_EQ(plane.normal, (Vec3{0, 0, -1})) << size;
    }
    EXPECT_NEAR(length(trace::Plane(yarte::Plane{{1e308, 1e308, -1e308}, 0}).normal), 1, 1e-15);
}

TEST(Box, ClosedForm) {
    const trace::Box box(yarte::Box{{1, 2, 3}, {2, 4, 6}}, Frame{});
    const auto c = crossings(box, {{1, 2, 10}, {0, 0, -1}, {}});
    ASSERT_EQ(c.count, 2);
    EXPECT_EQ(c.list[0].t, 4);
    EXPECT_EQ(c.list[0].part, 5);
    EXPECT_EQ(c.list[1].t, 10);
    EXPECT_EQ(c.list[1].part, 4);
    EXPECT_EQ(crossings(box, {{2.5, 2, 10}, {0, 0, -1}, {}}).count, 0);
    EXPECT_EQ(crossings(box, {{2.5, 2, 10}, {0, -0.0, -1}, {}}).count, 0);
}

} // namespace
