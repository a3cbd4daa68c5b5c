// Properties that every shape must have, and values known in closed form.
#include "yarte/scene/referential.h"
#include "yarte/trace/box.h"
#include "yarte/trace/cone.h"
#include "yarte/trace/disc.h"
#include "yarte/trace/frustum.h"
#include "yarte/trace/plane.h"
#include "yarte/trace/sphere.h"
#include "yarte/trace/truncated_cone.h"

#include "tests/support/scenes.h"

#include <gtest/gtest.h>

using namespace yarte;
using namespace yarte::trace;

namespace {

/// Each maker gives a random shape of its kind, turned by `axes` and moved by `centre`; `residual` is the
/// distance of a local point from the surface, relative to the shape's size.
struct SphereKind {
    using Shape = trace::Sphere;
    double r;
    explicit SphereKind(test::Random& random) : r(random.between(0.1, 3)) {}
    Shape make(Vec3 centre, const Frame&) const { return Shape(yarte::Sphere{centre, r}); }
    double residual(Vec3 p, std::uint8_t) const { return length(p) / r - 1; }
};
struct BoxKind {
    using Shape = trace::Box;
    Vec3 sides;
    explicit BoxKind(test::Random& random)
        : sides{random.between(0.1, 3), random.between(0.1, 3), random.between(0.1, 3)} {}
    Shape make(Vec3 centre, const Frame& axes) const { return Shape(yarte::Box{centre, sides}, axes); }
    double residual(Vec3 p, std::uint8_t) const {
        return std::max(
            {std::abs(p.x) - sides.x / 2, std::abs(p.y) - sides.y / 2, std::abs(p.z) - sides.z / 2});
    }
};
struct ConeKind {
    using Shape = trace::Cone;
    double r, h;
    explicit ConeKind(test::Random& random) : r(random.between(0.1, 3)), h(random.between(0.1, 3)) {}
    Shape make(Vec3 centre, const Frame& axes) const { return Shape(yarte::Cone{centre, r, h}, axes); }
    double residual(Vec3 p, std::uint8_t part) const {
        return part == 1 ? p.y : std::hypot(p.x, p.z) - r * (1 - p.y / h);
    }
};
struct TruncatedConeKind {
    using Shape = trace::TruncatedCone;
    double r, full, h;
    explicit TruncatedConeKind(test::Random& random)
        : r(random.between(0.1, 3)), full(random.between(0.1, 30)), h(full * random.between(0.1, 1)) {}
    Shape make(Vec3 centre, const Frame& axes) const {
        return Shape(yarte::TruncatedCone{centre, r, full, h}, axes);
    }
    double residual(Vec3 p, std::uint8_t) const { return std::hypot(p.x, p.z) - r * (1 - p.y / full); }
};
struct OpenCylinderKind {
    using Shape = trace::TruncatedCone;
    double r, h;
    explicit OpenCylinderKind(test::Random& random) : r(random.between(0.1, 3)), h(random.between(0.1, 3)) {}
    Shape make(Vec3 centre, const Frame& axes) const {
        return Shape(yarte::OpenCylinder{centre, r, h}, axes);
    }
    double residual(Vec3 p, std::uint8_t) const { return std::hypot(p.x, p.z) - r; }
};
struct CylinderKind {
    using Shape = trace::Frustum;
    double r, h;
    explicit CylinderKind(test::Random& random) : r(random.between(0.1, 3)), h(random.between(0.1, 3)) {}
    Shape make(Vec3 centre, const Frame& axes) const { return Shape(yarte::Cylinder{centre, r, h}, axes); }
    double residual(Vec3 p, std::uint8_t part) const {
        return part == 0 ? std::hypot(p.x, p.z) - r : part == 1 ? p.y : p.y - h;
    }
};
struct FrustumKind {
    using Shape = trace::Frustum;
    double r, top, h;
    /// Some nearly cylindrical, either end the larger.
    explicit FrustumKind(test::Random& random)
        : r(random.between(0.1, 3)),
          top(random.below(3) == 0 ? r * (1 + random.between(-1e-9, 1e-9)) : random.between(0.1, 3)),
          h(random.between(0.1, 3)) {}
    Shape make(Vec3 centre, const Frame& axes) const {
        return Shape(yarte::Frustum{centre, r, top, h}, axes);
    }
    double residual(Vec3 p, std::uint8_t part) const {
        return part == 0 ? std::hypot(p.x, p.z) - (r + (top - r) * p.y / h) : part == 1 ? p.y : p.y - h;
    }
};
struct DiscKind {
    using Shape = trace::Disc;
    double r;
    explicit DiscKind(test::Random& random) : r(random.between(0.1, 3)) {}
    Shape make(Vec3 centre, const Frame& axes) const { return Shape(yarte::Disc{centre, r}, axes); }
    double residual(Vec3 p, std::uint8_t) const { return p.y; }
};

template <class Kind>
class ShapeProperties : public testing::Test {};
using Kinds = testing::Types<SphereKind, BoxKind, ConeKind, TruncatedConeKind, DiscKind, OpenCylinderKind,
                             CylinderKind, FrustumKind>;
TYPED_TEST_SUITE(ShapeProperties, Kinds);

Ray towards(Vec3 target, Vec3 origin) { return {origin, normalised(target - origin), {}}; }

TYPED_TEST(ShapeProperties, CrossingsLieOnTheSurfaceWithOutwardUnitNormals) {
    int found = 0;
    for (unsigned seed = 1; seed <= 200; ++seed) {
        test::Random random(seed);
        const TypeParam kind(random);
        const Frame axes =
            std::is_same_v<TypeParam, SphereKind> ? Frame{} : resolveReferential(random.referential());
        const Vec3 centre = random.inCube(10);
        const auto shape = kind.make(centre, axes);
        for (int i = 0; i < 100; ++i) {
            const Ray ray = towards(centre + random.inCube(2), random.inCube(20));
            const auto list = crossings(shape, ray);
            if (TypeParam::Shape::isClosed) {
                EXPECT_TRUE(list.count == 0 || list.count == 2) << "seed " << seed;
            }
            if (list.count == 2) {
                EXPECT_LE(list.list[0].t, list.list[1].t) << "seed " << seed;
            }
            for (const Crossing& c : list) {
                ++found;
                const Vec3 point = ray.at(c.t), n = outwardNormal(shape, point, c.part);
                EXPECT_NEAR(kind.residual(axes.toLocal(point - centre), c.part), 0, 2e-13) << "seed " << seed;
                EXPECT_NEAR(length(n), 1, 1e-15) << "seed " << seed;
                const double slant = dot(n, ray.direction);
                if (std::abs(slant) > 1e-6) {
                    EXPECT_EQ(slant < 0, c.entering) << "seed " << seed;
                }
                const Bounds box = bounds(shape);
                EXPECT_GE(point.x, box.low.x - 1e-12);
                EXPECT_LE(point.x, box.high.x + 1e-12);
                EXPECT_GE(point.y, box.low.y - 1e-12);
                EXPECT_LE(point.y, box.high.y + 1e-12);
                EXPECT_GE(point.z, box.low.z - 1e-12);
                EXPECT_LE(point.z, box.high.z + 1e-12);
            }
        }
    }
    EXPECT_GT(found, 2000);
}

TYPED_TEST(ShapeProperties, MovingShapeAndRayTogetherMovesTheCrossings) {
    for (unsigned seed = 1; seed <= 200; ++seed) {
        test::Random random(seed);
        const TypeParam kind(random);
        const Vec3 centre = random.inCube(3), shift = random.inCube(10);
        const Frame turn = resolveReferential(random.referential());
        const auto still = kind.make(centre, Frame{});
        const auto moved = kind.make(turn.toWorld(centre) + shift, turn);
        for (int i = 0; i < 50; ++i) {
            const Ray ray = towards(centre + random.inCube(2), random.inCube(10));
            const Ray movedRay{turn.toWorld(ray.origin) + shift, normalised(turn.toWorld(ray.direction)), {}};
            const auto a = crossings(still, ray), b = crossings(moved, movedRay);
            ASSERT_EQ(a.count, b.count) << "seed " << seed;
            for (int k = 0; k < a.count; ++k) {
                // Near a tangent t is as ill-conditioned as the square root of its discriminant.
                const double chord = a.count == 2 ? a.list[1].t - a.list[0].t : 1;
                EXPECT_NEAR(a.list[k].t, b.list[k].t, 1e-12 / std::max(1e-6, std::min(1.0, chord)))
                    << "seed " << seed;
            }
        }
    }
}

TYPED_TEST(ShapeProperties, ScalingByAPowerOfTwoScalesTByExactlyIt) {
    for (unsigned seed = 1; seed <= 50; ++seed) {
        test::Random small(seed);
        const TypeParam kind(small);
        const Ray ray = towards({0.1, 0.02, -0.03}, small.inCube(10));
        const auto a = crossings(kind.make({}, Frame{}), ray);
        // The same shape and ray in units of 1/1024.
        TypeParam big = kind;
        if constexpr (requires { big.sides; }) big.sides = big.sides * 1024;
        if constexpr (requires { big.r; }) big.r *= 1024;
        if constexpr (requires { big.h; }) big.h *= 1024;
        if constexpr (requires { big.full; }) big.full *= 1024;
        if constexpr (requires { big.top; }) big.top *= 1024;
        const auto b = crossings(big.make({}, Frame{}), {ray.origin * 1024, ray.direction, {}});
        ASSERT_EQ(a.count, b.count);
        for (int k = 0; k < a.count; ++k) EXPECT_EQ(a.list[k].t * 1024, b.list[k].t) << "seed " << seed;
    }
}

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

TEST(Frustum, OfEqualRadiiIsACylinder) {
    test::Random random(5);
    for (int i = 0; i < 1000; ++i) {
        const Vec3 centre = random.inCube(3);
        const double r = random.between(0.1, 2), h = random.between(0.1, 5);
        const Frame axes = resolveReferential(random.referential());
        const Ray ray = towards(centre + random.inCube(1), random.inCube(10));
        const auto a = crossings(trace::Frustum(yarte::Cylinder{centre, r, h}, axes), ray),
                   b = crossings(trace::Frustum(yarte::Frustum{centre, r, r, h}, axes), ray);
        ASSERT_EQ(a.count, b.count);
        for (int k = 0; k < a.count; ++k) EXPECT_EQ(a.list[k].t, b.list[k].t);
    }
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
