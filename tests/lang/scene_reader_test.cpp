#include "tests/lang/read_text.h"

#include <fmt/format.h>

#include <gtest/gtest.h>

namespace yarte {
namespace {

using test::SceneText;

TEST(SceneReader, DefaultsAreThoseOfTheLanguage) {
    const SceneText read(test::header);
    ASSERT_TRUE(read.scene) << read.messages();
    const Scene& scene = *read.scene;
    EXPECT_EQ(scene.resolution, (Resolution{256, 256}));
    EXPECT_EQ(scene.camera, (Camera{{0, 0, 10}, {0, 0, 0}, {0, 1, 0}, 45, 45}));
    EXPECT_EQ(scene.background, Colour{});
    EXPECT_EQ(scene.maxRecursion, 2);
    EXPECT_EQ(scene.gamma, 1);
}

TEST(SceneReader, ReadsThePapersScene) {
    Sources sources;
    Diagnostics diagnostics;
    const auto scene = readScene(std::filesystem::path(YARTE_SOURCE_DIR) / "scenes" / "paper" / "paper.yarte",
                                 {{}, test::pmfOnly}, sources, diagnostics);
    ASSERT_TRUE(scene) << format(diagnostics, sources, DiagnosticStyle::plain);
    EXPECT_TRUE(diagnostics.all().empty());
    EXPECT_EQ(scene->gamma, 2.2);
    EXPECT_EQ(scene->lights.size(), 2U);
    EXPECT_EQ(scene->materials.size(), 7U);
    ASSERT_EQ(scene->bodies.size(), 8U);
    EXPECT_EQ(scene->bodies[0].shape, Shape(Sphere{{-60, -30, 20}, 40}));
    EXPECT_EQ(scene->bodies[3].shape, Shape(TruncatedCone{{-65, 50, 20}, 40, 80, 30}));
    EXPECT_EQ(scene->bodies[3].back, (BackColours{{0, 0, 0.2}, {0, 0, 0.8}, {0.2, 0.2, 0.2}}));
    EXPECT_EQ(scene->bodies[7].referential, (Referential{{0.707, 0.707, 0}, {-0.707, 0.707, 0}, Vec3{}}));
    EXPECT_EQ(scene->meshes[0].vertices.size(), 60U);
    EXPECT_EQ(scene->meshes[0].faceCount(), 32U);
}

TEST(SceneReader, EverySceneOfTheProjectIsGood) {
    int count = 0;
    for (const auto& entry :
         std::filesystem::recursive_directory_iterator(std::filesystem::path(YARTE_SOURCE_DIR) / "scenes")) {
        if (entry.path().extension() != ".yarte") continue;
        Sources sources;
        Diagnostics diagnostics;
        readScene(entry.path(), {{}, test::pmfOnly}, sources, diagnostics);
        EXPECT_EQ(format(diagnostics, sources, DiagnosticStyle::plain), "");
        ++count;
    }
    EXPECT_GT(count, 0);
}

TEST(SceneReader, SpansPointAtTheDirectives) {
    const std::string text = test::header + "disc 0 0 0\n 1 ; a comment\nbackface_colour 0 0 0 0 0 0 0 0 0\n";
    const SceneText read(text);
    ASSERT_TRUE(read.scene);
    const auto textOf = [&](Span span) { return text.substr(span.begin, span.end - span.begin); };
    EXPECT_EQ(textOf(read.scene->bodies[0].span), "disc 0 0 0\n 1");
    EXPECT_EQ(textOf(read.scene->lights[0].span), "light_source 0 9 9 1");
}

TEST(SceneReader, OneBadNumberIsOneError) {
    // What follows depends on the material, the object and the light with errors, and is not reported.
    const SceneText read(
        "camera_position 0 0 10\nfocus_point 0 0 0\nlight_source 0 9 9\nmaterial 0 0\n"
        "disc 0 0 0 x1\nbackface_colour 0 0 0 0 0 0 0 0 0\ninstance_referential 1 0 0 0 1 0\n");
    EXPECT_EQ(read.diagnostics.all().size(), 4U) << read.messages(); // light, material, disc, x1
}

TEST(SceneReader, MissingFileIsAnException) {
    Sources sources;
    Diagnostics diagnostics;
    EXPECT_THROW(readScene("no/such.yarte", {}, sources, diagnostics), FileError);
    EXPECT_THROW(readScene(YARTE_SOURCE_DIR, {}, sources, diagnostics), FileError);
}

TEST(SceneReader, NoPolygonOrSceneIsTooLarge) {
    std::string text = test::header + "polygon 10000";
    for (int i = 0; i < 10000; ++i) {
        const double angle = i * 6.283185307179586 / 10000;
        text += fmt::format(" {} {} 0", std::cos(angle), std::sin(angle));
    }
    for (int i = 0; i < 20000; ++i) text += "\nlight_source 0 0 0 1 sphere 0 0 0 1";
    const SceneText read(text);
    ASSERT_TRUE(read.scene) << read.messages();
    EXPECT_EQ(read.scene->bodies.size(), 20001U);
    EXPECT_EQ(read.scene->lights.size(), 20001U);
    EXPECT_EQ(std::get<Polygon>(read.scene->bodies[0].shape).vertices.size(), 10000U);
}

} // namespace
} // namespace yarte
