// Exact values in extras count only while the element still shows them: the visible always wins.
#include "tests/convert/gltf/support.h"
#include "tests/support/scenes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <functional>

namespace yarte::convert::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

/// A sphere and a box, a light, numbers that float32 does not hold.
Scene sphereAndBox() {
    Scene scene = yarte::test::emptyScene();
    scene.camera.focus = {0, 0.1, 0};
    yarte::test::add(scene, Sphere{{0.1, 0.2, 0.3}, 1.1}, {{0.1, 0, 0}, {0.7, 0.3, 0.1}, {0.2, 0.2, 0.2}, 33.3, 0.1, 0, 0});
    yarte::test::add(scene, Box{{-3.3, 0, 0}, {1, 2, 0.7}}, yarte::test::glass(0.9, 1.33));
    scene.lights.push_back({{1, 12.3, 4}, {0.9, 0.9, 0.8}});
    return scene;
}

ReadGltf changed(const std::function<void(json&)>& change) {
    json document = json::parse(written(sphereAndBox(), false));
    change(document);
    return ReadGltf(document.dump());
}

/// The node whose extras hold a line of the scene language that begins so.
json& nodeWith(json& document, const std::string& directive) {
    for (json& node : document["nodes"])
        if (node.contains("extras") && node["extras"].dump().find(directive + " ") != std::string::npos)
            return node;
    throw std::runtime_error("no node holds " + directive);
}

void removeExtras(json& value) {
    if (value.is_object()) value.erase("extras");
    if (value.is_structured())
        for (json& item : value) removeExtras(item);
}

TEST(VisibleWins, UnchangedIsExact) {
    const ReadGltf read = changed([](json&) {});
    ASSERT_TRUE(read.scene) << read.problems();
    EXPECT_EQ(printScene(*read.scene), printScene(sphereAndBox()));
}

/// Shapes, lights and what the rest of a material shows stay exact; only glass that became opaque is opaque.
TEST(VisibleWins, UnknownExtensionsMayGo) {
    const ReadGltf read = changed([](json& document) {
        std::function<void(json&)> strip = [&](json& value) {
            if (value.is_object()) value.erase("extensions");
            if (value.is_structured())
                for (json& item : value) strip(item);
        };
        strip(document);
        document.erase("extensionsUsed");
        document.erase("extensionsRequired");
    });
    ASSERT_TRUE(read.scene) << read.problems();
    Scene expected = sphereAndBox();
    expected.materials[1] = read.scene->materials.at(1);
    EXPECT_EQ(printScene(*read.scene), printScene(expected));
    EXPECT_EQ(expected.materials[1].transmission, 0);
    EXPECT_TRUE(read.tells("/materials/1", "exact", Action::dropped)) << summary(read.ledger);
}

TEST(VisibleWins, AMovedSphereStaysMovedAndIsNamed) {
    const ReadGltf read = changed([](json& document) {
        json& node = nodeWith(document, "sphere");
        node.erase("matrix");
        node["translation"] = {5.0, 6.0, 7.0};
    });
    ASSERT_TRUE(read.scene) << read.problems();
    const std::string text = printScene(*read.scene);
    EXPECT_THAT(text, Not(HasSubstr("sphere 0.1 0.2 0.3 1.1")));
    ASSERT_EQ(read.scene->bodies.size(), 2u);
    // What is seen is the tessellated sphere, about its new place.
    const Mesh* mesh = std::get_if<Mesh>(&read.scene->bodies[0].shape);
    ASSERT_NE(mesh, nullptr);
    const auto& vertices = read.scene->meshes[mesh->mesh.index].vertices;
    const auto middleOf = [&](double Vec3::*axis) {
        const auto [low, high] = std::ranges::minmax(vertices, {}, axis);
        return (low.*axis + high.*axis) / 2 * mesh->scale + mesh->translation.*axis;
    };
    const Vec3 middle{middleOf(&Vec3::x), middleOf(&Vec3::y), middleOf(&Vec3::z)};
    EXPECT_NEAR(middle.x, 5, 1e-3);
    EXPECT_NEAR(middle.y, 6, 1e-3);
    EXPECT_NEAR(middle.z, 7, 1e-3);
    // The other body is still exact, and the ledger names the node.
    EXPECT_THAT(text, HasSubstr("box -3.3 0 0 1 2 0.7"));
    EXPECT_THAT(summary(read.ledger), HasSubstr("exact"));
    bool named = false;
    for (const LedgerRow& row : read.ledger.rows())
        named |= row.where.starts_with("/nodes/") && row.action == Action::dropped && row.property.find("exact") == 0;
    EXPECT_TRUE(named) << summary(read.ledger);
}

TEST(VisibleWins, AMovedLightStaysMovedAndIsNamed) {
    const ReadGltf read = changed([](json& document) {
        json& node = nodeWith(document, "light_source");
        node.erase("matrix");
        node["translation"] = {2.0, 13.0, 5.0};
    });
    ASSERT_TRUE(read.scene) << read.problems();
    ASSERT_EQ(read.scene->lights.size(), 1u);
    EXPECT_EQ(read.scene->lights[0].position, (Vec3{2, 13, 5}));
    EXPECT_THAT(summary(read.ledger), HasSubstr("|exact light in extras|dropped"));
}

TEST(VisibleWins, AMovedCameraStaysMovedAndIsNamed) {
    const ReadGltf read = changed([](json& document) {
        json& node = nodeWith(document, "camera_position");
        for (const char* part : {"matrix", "rotation", "scale"}) node.erase(part);
        node["translation"] = {1.0, 2.0, 30.0};
    });
    ASSERT_TRUE(read.scene) << read.problems();
    EXPECT_EQ(read.scene->camera.position, (Vec3{1, 2, 30}));
    EXPECT_EQ(read.scene->camera.focus.x, 1);
    EXPECT_EQ(read.scene->camera.focus.y, 2);
    EXPECT_THAT(summary(read.ledger), HasSubstr("|exact camera in extras|dropped"));
}

/// What a tool that works in float32 does to a file without being asked is no change.
TEST(VisibleWins, RoundingToFloat32IsNoChange) {
    const ReadGltf read = changed([](json& document) {
        std::function<void(json&)> round = [&](json& value) {
            if (value.is_number_float()) value = static_cast<double>(value.get<float>());
            if (!value.is_structured()) return;
            for (auto& [key, item] : value.items())
                if (key != "extras") round(item);
        };
        round(document);
    });
    ASSERT_TRUE(read.scene) << read.problems();
    EXPECT_EQ(printScene(*read.scene), printScene(sphereAndBox()));
}

TEST(VisibleWins, APaintedMaterialStaysPainted) {
    const ReadGltf read = changed([](json& document) {
        for (json& material : document["materials"])
            material["pbrMetallicRoughness"]["baseColorFactor"] = {0.0, 1.0, 0.0, 1.0};
    });
    ASSERT_TRUE(read.scene) << read.problems();
    const Material& m = read.scene->materials[read.scene->bodies[0].material.index];
    EXPECT_EQ(m.diffuse.r, 0);
    EXPECT_GT(m.diffuse.g, 0.3);
    EXPECT_THAT(printScene(*read.scene), HasSubstr("sphere 0.1 0.2 0.3 1.1")) << "its shape is as it was";
}

TEST(VisibleWins, WithoutExtrasTheMeshesComeBack) {
    const ReadGltf read = changed([](json& document) { removeExtras(document); });
    ASSERT_TRUE(read.scene) << read.problems();
    ASSERT_EQ(read.scene->bodies.size(), 2u);
    for (const Body& body : read.scene->bodies) EXPECT_TRUE(std::holds_alternative<Mesh>(body.shape));
    EXPECT_EQ(read.scene->lights.size(), 1u);
}

TEST(VisibleWins, DamagedExtrasAreNoErrorButAreTold) {
    const ReadGltf read = changed([](json& document) {
        json& node = nodeWith(document, "sphere");
        std::string text = node["extras"].dump();
        text.replace(text.find("sphere "), 7, "sphear ");
        node["extras"] = json::parse(text);
    });
    ASSERT_TRUE(read.scene) << read.problems();
    EXPECT_TRUE(std::holds_alternative<Mesh>(read.scene->bodies[0].shape));
    EXPECT_THAT(printScene(*read.scene), HasSubstr("box -3.3 0 0 1 2 0.7"));
}

} // namespace
} // namespace yarte::convert::test
