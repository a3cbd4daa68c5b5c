#include "tests/lang/read_text.h"

#include "tests/support/scenes.h"
#include "yarte/lang/scene_printer.h"

#include <gtest/gtest.h>

namespace yarte {
namespace {

constexpr const char* settings = "image_resolution 256 256\n"
                                 "camera_position 0 0 10\n"
                                 "camera_apertures 45 45\n"
                                 "focus_point 0 0 0\n"
                                 "up_vector 0 1 0\n"
                                 "background_colour 0 0 0\n"
                                 "max_recurse_level 2\n"
                                 "gamma_correction_factor 1\n";

TEST(ScenePrinter, EmptySceneIsItsSettings) { EXPECT_EQ(printScene(test::emptyScene()), settings); }

TEST(ScenePrinter, BrightnessIsOneNumberWhereItCanBe) {
    Scene scene = test::emptyScene();
    scene.lights = {{{1, 2, 3}, {0.5, 0.5, 0.5}}, {{1, 2, 3}, {0.5, 0.5, 0.25}}, {{1, 2, 3}, {0, -0.0, 0}}};
    EXPECT_EQ(printScene(scene), std::string(settings) + "\nlight_source 1 2 3 0.5\n"
                                                         "light_source 1 2 3 0.5 0.5 0.25\n"
                                                         "light_source 1 2 3 0 -0 0\n");
}

TEST(ScenePrinter, ATintOfWhiteIsNone) {
    Scene scene = test::emptyScene();
    scene.materials = {test::glass(0.5, 1.5), test::glass(0.5, 1.5), test::glass(0, 0)};
    scene.materials[1].tint = scene.materials[2].tint = {1, 0.5, 1};
    EXPECT_EQ(printScene(scene), std::string(settings) + "\nmaterial 0 0 0 0 0 0 0 0 0 1 0 0.5 1.5\n"
                                                         "\nmaterial 0 0 0 0 0 0 0 0 0 1 0 0.5 1.5\n"
                                                         "tint 1 0.5 1\n"
                                                         "\nmaterial 0 0 0 0 0 0 0 0 0 1 0 0 0\n"
                                                         "tint 1 0.5 1\n");
}

TEST(ScenePrinter, MaterialsComeOnceAndUnusedOnesStay) {
    Scene scene = test::emptyScene();
    for (const double red : {0.1, 0.2, 0.3, 0.4}) scene.materials.push_back(test::matt({red, 0, 0}));
    for (const std::uint32_t id : {1, 1, 2}) scene.bodies.push_back({Sphere{}, {id}, {}, {}, {}});
    EXPECT_EQ(printScene(scene), std::string(settings) + "\nmaterial 0 0 0 0.1 0 0 0 0 0 1 0 0 0\n"
                                                         "\nmaterial 0 0 0 0.2 0 0 0 0 0 1 0 0 0\n"
                                                         "sphere 0 0 0 1\n"
                                                         "sphere 0 0 0 1\n"
                                                         "\nmaterial 0 0 0 0.3 0 0 0 0 0 1 0 0 0\n"
                                                         "sphere 0 0 0 1\n"
                                                         "\nmaterial 0 0 0 0.4 0 0 0 0 0 1 0 0 0\n");
}

TEST(ScenePrinter, MaterialsInAnyOrderKeepTheirMeaning) {
    // A converter may number materials otherwise than the text can.
    Scene scene = test::emptyScene();
    for (const double red : {0.1, 0.2, 0.3}) scene.materials.push_back(test::matt({red, 0, 0}));
    for (const std::uint32_t id : {2, 0, 0, 2, 1}) scene.bodies.push_back({Sphere{}, {id}, {}, {}, {}});
    const std::string text = printScene(scene);
    const test::SceneText read(text);
    ASSERT_TRUE(read.scene) << read.messages();
    for (std::size_t i = 0; i < scene.bodies.size(); ++i)
        EXPECT_EQ(read.scene->materials[read.scene->bodies[i].material.index],
                  scene.materials[scene.bodies[i].material.index])
            << i;
    EXPECT_EQ(printScene(*read.scene), text);
}

TEST(ScenePrinter, FileNamesAreQuotedOnlyWhereNeeded) {
    const auto printed = [](const std::string& name) {
        Scene scene = test::emptyScene();
        MeshData mesh;
        mesh.path = name;
        test::addMesh(scene, mesh, test::matt({1, 1, 1}));
        const std::string text = printScene(scene);
        const std::size_t begin = text.find("\nmesh ") + 6;
        return text.substr(begin, text.find(" 1 1 0 0", begin) - begin);
    };
    for (const char* name : {"buck.pmf", "../a/b.glb", "60.pmf", "./1", "a\"b.pmf", "caf\xC3\xA9.pmf", "nan"})
        EXPECT_EQ(printed(name), name);
    EXPECT_EQ(printed("two words.pmf"), "\"two words.pmf\"");
    EXPECT_EQ(printed("a;b.pmf"), "\"a;b.pmf\"");
    EXPECT_EQ(printed("\"x\""), "\"\"\"x\"\"\"");
    EXPECT_EQ(printed("sphere"), "\"sphere\"");
    EXPECT_EQ(printed("1e3"), "\"1e3\"");
    EXPECT_EQ(printed("1e999"), "\"1e999\"");
    EXPECT_EQ(printed(""), "\"\"");
}

} // namespace
} // namespace yarte
