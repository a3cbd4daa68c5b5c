// Shapes as glTF shows them to programs that do not look into extras.
#include "tests/convert/gltf/support.h"
#include "tests/support/scenes.h"

#include "convert/tessellate.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace yarte::convert::test {
namespace {

using nlohmann::json;
using yarte::test::matt;

Scene sceneOf(const Shape& shape) {
    Scene scene = yarte::test::emptyScene();
    yarte::test::add(scene, shape, matt({0.5, 0.6, 0.7}));
    scene.lights.push_back({{1, 12, 4}, {1, 1, 1}});
    return scene;
}

Ledger ledgerOf(const Scene& scene) {
    Sources sources;
    Diagnostics diagnostics;
    Ledger ledger;
    Conversion c{{}, {}, {}, sources, diagnostics, ledger};
    gltf::writeGltf(scene, c);
    return ledger;
}

/// The scene as a program sees it that knows no extras.
Scene visible(const Scene& scene) {
    json document = json::parse(written(scene, false));
    const auto removeExtras = [](auto& self, json& value) -> void {
        if (value.is_object()) value.erase("extras");
        if (value.is_structured())
            for (json& item : value) self(self, item);
    };
    removeExtras(removeExtras, document);
    const ReadGltf read(document.dump());
    EXPECT_TRUE(read.scene) << read.problems();
    return read.scene.value_or(Scene{});
}

/// Vertices in their places, and the sum of the faces' area vectors.
struct Shown {
    std::vector<Vec3> vertices;
    Vec3 area;
    double volume = 0;
};

Shown shown(const Scene& scene) {
    Shown result;
    for (const Body& body : scene.bodies) {
        const auto& mesh = std::get<Mesh>(body.shape);
        const MeshData& data = scene.meshes[mesh.mesh.index];
        std::vector<Vec3> placed;
        for (const Vec3 v : data.vertices)
            placed.push_back(mesh.axes.x * (v.x * mesh.scale) + mesh.axes.y * (v.y * mesh.scale) +
                             mesh.axes.z.value_or(cross(mesh.axes.x, mesh.axes.y)) * (v.z * mesh.scale) +
                             mesh.translation);
        for (std::size_t f = 0; f < data.faceCount(); ++f) {
            const auto face = data.face(f);
            const Vec3 a = placed[face[0]], b = placed[face[1]], c = placed[face[2]];
            result.area += cross(b - a, c - a) / 2;
            result.volume += dot(a, cross(b, c)) / 6;
        }
        result.vertices.insert(result.vertices.end(), placed.begin(), placed.end());
    }
    return result;
}

TEST(GltfShapes, APlaneIsALargeSquareInIt) {
    Scene scene = sceneOf(Plane{{1, 2, -2}, 6});
    yarte::test::add(scene, Sphere{{0, 1, 0}, 1}, matt({1, 0, 0}));
    const Scene seen = visible(scene);
    ASSERT_EQ(seen.bodies.size(), 2u);
    Scene square = seen;
    square.bodies.resize(1);
    const Shown found = shown(square);
    double reach = 0;
    for (const Vec3 v : found.vertices) {
        EXPECT_NEAR(dot(v, {1, 2, -2}) / 3, 6, 1e-3) << "in the plane, but for rounding to float32";
        reach = std::max(reach, length(v));
    }
    EXPECT_GT(reach, 300) << "far beyond everything else";
    EXPECT_LT(length(normalised(found.area) - Vec3{1, 2, -2} / 3), 1e-6)
        << "its front is where the normal points";
    bool isTold = false;
    const Ledger ledger = ledgerOf(scene);
    for (const LedgerRow& row : ledger.rows())
        isTold |= row.where == "body 1" && row.property == "extent" && row.action == Action::approximated;
    EXPECT_TRUE(isTold) << "that it ends";
}

TEST(GltfShapes, PlanesDoNotMoveTheCamerasNearestDistance) {
    Scene scene = sceneOf(Sphere{{0, 1, 0}, 1});
    const auto znear = [](const Scene& s) {
        return json::parse(written(s, false))["cameras"][0]["perspective"]["znear"].get<double>();
    };
    const double before = znear(scene);
    yarte::test::add(scene, Plane{{0, 1, 0}, -5000}, matt({1, 1, 1}));
    EXPECT_EQ(znear(scene), before);
}

TEST(GltfShapes, PlanesAloneAndAtTheLimitsOfDoubleAreTheSameText) {
    for (const double size : {0.0, 1.0, 1e-300, 1e30, 1e60, 1e200, 1.7e308})
        for (const bool binary : {true, false}) {
            const Scene scene = sceneOf(Plane{{size, -1, 0.1}, size});
            const ReadGltf back(written(scene, binary));
            ASSERT_TRUE(back.scene) << size << '\n' << back.problems();
            EXPECT_EQ(printScene(*back.scene), printScene(scene)) << size;
        }
}

TEST(GltfShapes, CylindersAndFrustumsAreClosedAndFullAsTheyShouldBe) {
    const double pi = std::acos(-1.0);
    const auto volume = [](const Shape& shape) {
        const Shown found = shown(visible(sceneOf(shape)));
        EXPECT_LT(length(found.area), 1e-4) << "closed";
        return found.volume;
    };
    EXPECT_NEAR(volume(Cylinder{{1, 2, 3}, 2, 3}) / (pi * 12), 1, 2e-3);
    EXPECT_NEAR(volume(Frustum{{1, 2, 3}, 2, 1, 3}) / (pi * 7), 1, 2e-3); // h/3 (R^2 + R r + r^2)
    EXPECT_NEAR(volume(Frustum{{1, 2, 3}, 1, 2, 3}) / (pi * 7), 1, 2e-3);
    const Shown tube = shown(visible(sceneOf(OpenCylinder{{0, -1.5, 0}, 2, 3})));
    EXPECT_NEAR(tube.volume / (pi * 12 * 2 / 3), 1, 2e-3) << "the wall's part of it, its front outside";
}

TEST(GltfShapes, ChordsStayWithinTheirError) {
    for (const auto& [bottom, top] : {std::pair{2.0, 2.0}, {2.0, 0.5}, {0.5, 2.0}}) {
        const Tessellation t = tessellateCone(bottom, top, 3, {true, true}, 0.01);
        EXPECT_LE(t.deviation, 0.01);
        EXPECT_GT(t.deviation, 0.001);
    }
}

TEST(GltfShapes, WhatImplicitShapesCanSayIsSaidExactly) {
    const json cylinder = json::parse(written(sceneOf(Cylinder{{0, 0, 0}, 0.1, 3}), false)),
               frustum = json::parse(written(sceneOf(Frustum{{0, 0, 0}, 1, 2, 0.3}), false));
    EXPECT_EQ(
        cylinder["extensions"]["KHR_implicit_shapes"]["shapes"][0],
        json::parse(R"({"type":"cylinder","cylinder":{"height":3,"radiusBottom":0.1,"radiusTop":0.1}})"));
    EXPECT_EQ(frustum["extensions"]["KHR_implicit_shapes"]["shapes"][0],
              json::parse(R"({"type":"cylinder","cylinder":{"height":0.3,"radiusBottom":1,"radiusTop":2}})"));
    const json plane = json::parse(written(sceneOf(Plane{}), false));
    EXPECT_EQ(plane["extensions"]["KHR_implicit_shapes"]["shapes"][0],
              json::parse(R"({"type":"plane","plane":{}})"))
        << "without sizes it is infinite";
    EXPECT_FALSE(
        json::parse(written(sceneOf(OpenCylinder{}), false))["extensions"].contains("KHR_implicit_shapes"));
}

} // namespace
} // namespace yarte::convert::test
