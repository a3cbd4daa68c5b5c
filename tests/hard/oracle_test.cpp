// The oracle against closed forms, against its own second arithmetic, and against what it claims of rounding.
#include "tests/hard/oracle.h"

#include "tests/hard/surfaces.h"
#include "tests/support/scenes.h"
#include "yarte/scene/referential.h"

#include <gtest/gtest.h>

using namespace yarte;
using namespace yarte::hard;

namespace {

Scene sceneOf(Shape shape, std::optional<Referential> axes = {}) {
    Scene scene = test::emptyScene();
    test::add(scene, std::move(shape), test::matt({1, 1, 1})).referential = axes;
    return scene;
}

bool areEqual(const Real& a, const Real& b) { return abs(a - b) <= Real("1e-120") * (1 + abs(b)); }

TEST(Oracle, SphereInClosedForm) {
    const Scene scene = sceneOf(Sphere{{0, 0, 0}, 3});
    const Truth truth = truthOf(scene, {{0, 1, 10}, {0, 0, -1}});
    ASSERT_TRUE(truth.hit && truth.isDecidable);
    EXPECT_TRUE(areEqual(truth.hit->t, 10 - sqrt(Real(8))));
    EXPECT_TRUE(areEqual(truth.hit->normal.y, Real(1) / 3));
    EXPECT_TRUE(areEqual(truth.hit->normal.z, sqrt(Real(8)) / 3));
    EXPECT_TRUE(truth.hit->entering);
    const Truth inside = truthOf(scene, {{0, 1, 0}, {0, 0, -1}});
    ASSERT_TRUE(inside.hit && inside.isDecidable);
    EXPECT_FALSE(inside.hit->entering);
    EXPECT_FALSE(truthOf(scene, {{0, 3.001, 10}, {0, 0, -1}}).hit);
    EXPECT_FALSE(truthOf(scene, {{0, 0, 10}, {0, 0, 1}}).hit);
}

TEST(Oracle, FromInsideASphereIsLeftOnce) {
    for (const double x : {-0.9, -0.5, 0.0, 0.5, 0.9})
        for (const double side : {-1, 1}) {
            const Truth truth = truthOf(sceneOf(Sphere{{0, 0, 0}, 1}), {{x, 0, 0}, {side, 0, 0}});
            ASSERT_TRUE(truth.hit && truth.isDecidable);
            EXPECT_TRUE(areEqual(truth.hit->t, 1 - side * Real(x)));
            EXPECT_FALSE(truth.hit->entering);
        }
}

TEST(Oracle, TCountsTheDirectionAsItIs) {
    const Truth truth = truthOf(sceneOf(Sphere{{0, 0, 0}, 1}), {{0, 0, 5}, {0, 0, -2}});
    ASSERT_TRUE(truth.hit);
    EXPECT_TRUE(areEqual(truth.hit->t, 2));
}

TEST(Oracle, WhatRoundingMayChangeIsNotDecidable) {
    const Scene scene = sceneOf(Sphere{{0, 0, 0}, 1});
    // The tangent at height 1: half an ulp of 1 is 2^-53 up to 1, so 2^-53 of r and of y each; r^2 - y^2
    // moves by 2 (2^-53 + 2^-53).
    const Truth touching = truthOf(scene, {{0, 1, 10}, {0, 0, -1}});
    EXPECT_FALSE(touching.isDecidable);
    EXPECT_NEAR(touching.range, 4 * 0x1p-53, 1e-20);
    EXPECT_FALSE(truthOf(scene, {{0, 1 + 0x1p-52, 10}, {0, 0, -1}}).isDecidable);
    const Truth beside = truthOf(scene, {{0, 1 + 0x1p-51, 10}, {0, 0, -1}});
    EXPECT_TRUE(beside.isDecidable);
    EXPECT_FALSE(beside.hit);
    EXPECT_EQ(beside.deciding, "discriminant");
    // From afar, only the direction as it is written counts: of 0 half an ulp is nothing, of 1e-3 it is a
    // lot.
    EXPECT_TRUE(truthOf(scene, {{0, 1 + 1e-12, 1e9}, {0, 0, -1}}).isDecidable);
    EXPECT_FALSE(truthOf(scene, {{0, 1e6 + std::sqrt(1 + 1e-6) + 1e-10, 1e9}, {0, -1e-3, -1}}).isDecidable);
}

TEST(Oracle, ConeInClosedForm) {
    const Scene scene = sceneOf(Cone{{0, 0, 0}, 3, 4});
    const Truth across = truthOf(scene, {{-10, 2, 0}, {1, 0, 0}});
    ASSERT_TRUE(across.hit && across.isDecidable);
    EXPECT_TRUE(areEqual(across.hit->t, Real("8.5")));
    EXPECT_TRUE(areEqual(across.hit->normal.x, Real("-0.8")));
    EXPECT_TRUE(areEqual(across.hit->normal.y, Real("0.6")));
    const Truth up = truthOf(scene, {{1.5, -3, 0}, {0, 1, 0}});
    ASSERT_TRUE(up.hit && up.isDecidable);
    EXPECT_TRUE(areEqual(up.hit->t, 3));
    EXPECT_TRUE(areEqual(up.hit->normal.y, -1));
    EXPECT_FALSE(truthOf(scene, {{-10, 4.5, 0}, {1, 0, 0}}).hit); // where the upper nappe would be
}

TEST(Oracle, ParallelToAGenerator) {
    // One root of the quadratic is at infinity, with and without rounding.
    const Scene scene = sceneOf(Cone{{0, 0, 0}, 1, 1});
    const InputRay ray{{-1, 1, 0}, {1, -1, 0}};
    const Truth truth = truthOf(scene, ray);
    ASSERT_TRUE(truth.hit && truth.isDecidable);
    EXPECT_TRUE(areEqual(truth.hit->t, Real("0.5")));
    const auto exact = exactTruthOf(scene, ray);
    ASSERT_TRUE(exact);
    EXPECT_TRUE(areEqual(exact->t, Real("0.5")));
}

TEST(Oracle, TurnedAxesAreTheClosestRotation) {
    // Lengths do not matter, and y leans: x and y are moved by half of it each.
    const double lean = 1e-4;
    const Referential axes{{7, 0, 0}, {lean, 1, 0}, {}};
    const auto exact = exactRotation(axes);
    EXPECT_TRUE(areEqual(exact.x.x, cos(atan(Real(lean)) / 2)));
    EXPECT_TRUE(areEqual(exact.x.y, -sin(atan(Real(lean)) / 2)));
    const Truth truth = truthOf(sceneOf(Disc{{0, 1, 0}, 2}, axes), {{0, 5, 0}, {0, -1, 0}});
    ASSERT_TRUE(truth.hit && truth.isDecidable);
    EXPECT_TRUE(areEqual(truth.hit->t, 4));
    EXPECT_TRUE(areEqual(truth.hit->normal.x, exact.y.x));
}

TEST(Oracle, PolygonIsFilledEvenOdd) {
    const Scene scene = sceneOf(Polygon{{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}}});
    test::Random random(1);
    for (int i = 0; i < 300; ++i) {
        const double x = random.between(-0.5, 2.5), y = random.between(-0.5, 2.5);
        const bool inL = x > 0 && y > 0 && x < 2 && y < 2 && (x < 1 || y < 1);
        const Truth truth = truthOf(scene, {{x, y, 3}, {0, 0, -1}});
        EXPECT_TRUE(truth.isDecidable);
        EXPECT_EQ(truth.hit.has_value(), inL) << x << ' ' << y;
    }
    EXPECT_FALSE(truthOf(scene, {{1, 1.5, 3}, {0, 0, -1}}).isDecidable); // on an edge
    EXPECT_FALSE(truthOf(scene, {{1, 1, 3}, {0, 0, -1}}).isDecidable);   // in a corner
}

TEST(Oracle, OfTwoInOnePlaceTheFirstInTheFile) {
    Scene scene = sceneOf(Polygon{{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}});
    test::add(scene, Box{{0, 0, -1}, {2, 2, 2}}, test::matt({0, 1, 0}));
    const InputRay ray{{0.25, 0.5, 5}, {0, 0, -1}};
    ASSERT_TRUE(exactTruthOf(scene, ray));
    EXPECT_EQ(exactTruthOf(scene, ray)->body, 0U);
    EXPECT_FALSE(truthOf(scene, ray).isDecidable);
    std::swap(scene.bodies[0], scene.bodies[1]);
    EXPECT_EQ(exactTruthOf(scene, ray)->body, 0U);
}

TEST(Oracle, RootsAreOrderedExactly) {
    const auto surd = [](int p, int q, int d) { return Surd<Rational>{p, q, d}; };
    const auto sign = [](const auto& a, const auto& b) { return compare(a, b, "").sign; };
    EXPECT_EQ(sign(surd(0, 1, 2), surd(1, 0, 0)), 1);  // sqrt 2 > 1
    EXPECT_EQ(sign(surd(1, 1, 2), surd(0, 1, 6)), -1); // 2.414 < 2.449
    EXPECT_EQ(sign(surd(0, 1, 8), surd(0, 2, 2)), 0);
    EXPECT_EQ(sign(surd(5, -1, 2), surd(5, -1, 3)), 1);
    EXPECT_EQ(sign(surd(-7, 1, 50), surd(0, 0, 0)), 1);
    EXPECT_EQ(sign(surd(0, 665857, 2), surd(470832 * 2, 0, 0)), 1); // a convergent of sqrt 2, from below
}

/// Both arithmetics give the same answers, the point lies on the surface, and no nearer one is missed.
TEST(Oracle, BothArithmeticsAgree) {
    int hits = 0, decided = 0;
    for (unsigned seed = 1; seed <= 6; ++seed) {
        Scene scene = test::mixedScene(9, seed); // the tenth is a placed mesh
        test::addPlanes(scene, 1, seed);
        test::Random random(seed);
        for (int i = 0; i < 10; ++i) {
            const Vec3 origin = random.inCube(12);
            const InputRay ray{origin, normalised(random.inCube(8) - origin)};
            const Truth truth = truthOf(scene, ray);
            const auto exact = exactTruthOf(scene, ray);
            decided += truth.isDecidable;
            ASSERT_EQ(truth.hit.has_value(), exact.has_value()) << seed << ' ' << i;
            if (!exact) continue;
            ++hits;
            EXPECT_EQ(truth.hit->body, exact->body);
            EXPECT_EQ(truth.hit->entering, exact->entering);
            EXPECT_TRUE(areEqual(truth.hit->t, exact->t));
        }
    }
    EXPECT_GT(hits, 40);
    EXPECT_EQ(decided, 60);
}

TEST(Oracle, ConditionIsWhatAnInputsChangeDoes) {
    // t = 10 - sqrt(r^2 - y^2): its sensitivity to r is r^2 / sqrt(r^2 - y^2), to y likewise; to the centre's
    // 0 it is none.
    const Scene scene = sceneOf(Sphere{{0, 0, 0}, 1});
    const double y = 0.75, h = std::sqrt(1 - y * y), t = 10 - h;
    const Truth truth = truthOf(scene, {{0, y, 10}, {0, 0, -1}});
    ASSERT_TRUE(truth.hit);
    const double byDirection = t; // dt/dd . d = -t
    EXPECT_NEAR(truth.hit->tCondition, (10 + byDirection + 1 / h + y * y / h) / t, 1e-12);
}

TEST(Uncertain, IsNeverLeftByTheExactValue) {
    test::Random random(4);
    for (int i = 0; i < 200; ++i) {
        Inputs<Uncertain> inputs;
        double x[3], moved[3];
        Uncertain u[3];
        // Inputs in single precision's place: half an ulp of x is far above that of the arithmetic that
        // checks.
        for (int k = 0; k < 3; ++k) {
            x[k] = random.between(0.5, 2), u[k] = inputs.number(x[k]);
            moved[k] = random.between(-1, 1) * halfUlp(x[k]);
        }
        const auto f = [](const auto& a, const auto& b, const auto& c) {
            return sqrt(a * a + b / c) - (a - b) * c / (a + b);
        };
        const Uncertain value = f(u[0], u[1], u[2]);
        const Real exact =
            f(Real(Real(x[0]) + moved[0]), Real(Real(x[1]) + moved[1]), Real(Real(x[2]) + moved[2]));
        EXPECT_LE(static_cast<double>(abs(exact - value.value())), value.range());
        EXPECT_LE(value.range(), 20 * 0x1p-53);
    }
}

} // namespace
