// Properties that every shape must have. Values known in closed form are in closed_form_test.cpp.
#include "yarte/scene/referential.h"
#include "yarte/trace/box.h"
#include "yarte/trace/cone.h"
#include "yarte/trace/disc.h"
#include "yarte/trace/frustum.h"
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

} // namespace
