// What POV-Ray makes of our SDL: it reads every scene without a complaint, and shows values that are known in
// closed form. (Whether whole pictures agree with YARTE's is tested by yarte-validate.)
#include "tests/convert/support.h"
#include "tests/support/povray.h"
#include "tests/support/program.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <numbers>

namespace yarte::convert::test {
namespace {

constexpr int width = 24, height = 18;

struct Picture {
    std::vector<Colour> pixels; ///< rows from the top
    std::string said;           ///< on the console
};

class Povray : public testing::Test {
protected:
    void SetUp() override {
        if (!yarte::test::hasPovray()) GTEST_SKIP() << "skipped: povray not found";
    }

    Picture render(const Options& wanted) const {
        const Converted run(wanted);
        EXPECT_EQ(run.files.size(), 1U) << run.problems();
        if (run.files.empty()) return {};
        writeFile(folder_ / "scene.pov", run.files[0].bytes);
        const auto [exitCode, said] =
            yarte::test::runPovray(folder_, "+Iscene.pov +Oout.ppm +FP16 +W" + std::to_string(width) + " +H" +
                                                std::to_string(height) + " -D -A -P +WT1 +Q9 File_Gamma=1");
        EXPECT_EQ(exitCode, 0) << said;
        return exitCode == 0 ? Picture{pixels(readFile(folder_ / "out.ppm")), said} : Picture{{}, said};
    }

    Picture renderText(const std::string& scene) const {
        writeFile(folder_ / "scene.yarte", scene);
        return render(options(folder_ / "scene.yarte", folder_ / "scene.pov"));
    }

private:
    static std::vector<Colour> pixels(const std::string& ppm) {
        const std::size_t bytes = std::size_t{width} * height * 6;
        EXPECT_GT(ppm.size(), bytes);
        std::vector<Colour> result;
        const auto sample = [&](std::size_t i) {
            return (static_cast<unsigned char>(ppm[i]) * 256 + static_cast<unsigned char>(ppm[i + 1])) /
                   65535.0;
        };
        for (std::size_t i = ppm.size() - bytes; i < ppm.size(); i += 6)
            result.push_back({sample(i), sample(i + 2), sample(i + 4)});
        return result;
    }

    const std::filesystem::path folder_ = yarte::test::emptyTestFolder();
};

constexpr double halfStep = 0.51 / 65535; // of a 16-bit file

void expectEverywhere(const Picture& picture, Colour expected) {
    ASSERT_EQ(picture.pixels.size(), std::size_t{width} * height);
    for (const Colour c : picture.pixels) {
        ASSERT_NEAR(c.r, expected.r, halfStep);
        ASSERT_NEAR(c.g, expected.g, halfStep);
        ASSERT_NEAR(c.b, expected.b, halfStep);
    }
}

/// A camera that looks along -z at a wall that fills the picture.
const std::string look =
    "camera_position 0 0 4\nfocus_point 0 0 0\ncamera_apertures 30 25\nbackground_colour 0.5 0.25 0.125\n";
const std::string wall = "polygon 4 -9 -9 0 9 -9 0 9 9 0 -9 9 0\n";
const std::string backWall = "polygon 4 9 -9 0 -9 -9 0 -9 9 0 9 9 0\n";

void expectNoWarning(const Picture& picture, const std::filesystem::path& scene) {
    EXPECT_EQ(picture.said.find("Warning:"), std::string::npos) << scene << "\n" << picture.said;
    EXPECT_EQ(picture.said.find("egenerate"), std::string::npos) << scene << "\n" << picture.said;
}

TEST_F(Povray, ReadsEverySceneWithoutAWarning) {
    std::size_t count = 0;
    for (const auto& entry :
         std::filesystem::directory_iterator(std::filesystem::path(YARTE_SOURCE_DIR) / "scenes")) {
        if (!entry.is_directory()) continue;
        const auto scene = entry.path() / (entry.path().filename().string() + ".yarte");
        expectNoWarning(render(options(scene, "scene.pov")), scene);
        ++count;
    }
    EXPECT_GT(count, 14U);
}

TEST_F(Povray, ReadsEveryFormOfABodyWithoutAWarning) {
    for (const char* scene : {"shapes.yarte", "meshes.yarte"}) {
        for (const bool plain : {false, true}) {
            Options wanted = options(goldenFolder / scene, "scene.pov");
            wanted.writing.plainTextures = plain;
            expectNoWarning(render(wanted), scene);
        }
    }
}

TEST_F(Povray, ShowsBackgroundAndAmbient) {
    expectEverywhere(
        renderText(look + "light_source 0 0 9 1\nmaterial 1 1 1 1 1 1 0 0 0 1 0 0 0\nsphere 0 0 9 1\n"),
        {0.5, 0.25, 0.125});
    expectEverywhere(renderText(look + "material 0.2 0 0.7 0 0 0 0 0 0 1 0 0 0\n" + wall), {0.2, 0, 0.7});
}

TEST_F(Povray, ShowsBackColoursFromBehind) {
    const std::string material = "material 0.2 0 0.7 0 0 0 0 0 0 1 0 0 0\n",
                      back = "backface_colour 0 0.6 0 0 0 0 0 0 0\n";
    expectEverywhere(renderText(look + material + wall + back), {0.2, 0, 0.7});
    expectEverywhere(renderText(look + material + backWall + back), {0, 0.6, 0});
}

TEST_F(Povray, TakesTheFrontFromTheWholePolygon) {
    // Clockwise, so seen from behind; the second corner is reflex: the first three vertices alone turn the
    // other way.
    expectEverywhere(renderText(look + "material 0.2 0 0.7 0 0 0 0 0 0 1 0 0 0\n"
                                       "polygon 5 -99 99 0 0 3 0 99 99 0 99 -99 0 -99 -99 0\n"
                                       "backface_colour 0 0.6 0 0 0 0 0 0 0\n"),
                     {0, 0.6, 0});
}

TEST_F(Povray, AddsWhatIsMirroredAndWhatShinesThrough) {
    expectEverywhere(renderText(look + "material 0.1 0.2 0.3 0 0 0 0 0 0 1 0.5 0 0\n" + wall),
                     {0.35, 0.325, 0.3625});
    expectEverywhere(renderText(look + "material 0.1 0.2 0.3 0 0 0 0 0 0 1 0 1 1\n" + wall),
                     {0.6, 0.45, 0.425});
    expectEverywhere(renderText(look + "material 0.1 0.2 0.3 0 0 0 0 0 0 1 0.5 0.75 1\n" + wall),
                     {0.1 + 1.25 * 0.5, 0.2 + 1.25 * 0.25, 0.3 + 1.25 * 0.125});
}

TEST_F(Povray, ShowsBlackBeyondTheLastLevel) {
    expectEverywhere(
        renderText(look + "max_recurse_level 0\nmaterial 0.1 0.2 0.3 0 0 0 0 0 0 1 0.5 0 0\n" + wall),
        {0.1, 0.2, 0.3});
}

/// The light at the camera: with c the cosine between view and normal, N.L = c and R.L = 2 c^2 - 1.
TEST_F(Povray, ShadesByPhong) {
    const Picture picture = renderText(
        "camera_position 0 0 4\nfocus_point 0 0 0\ncamera_apertures 30 25\nlight_source 0 0 4 0.5\n"
        "material 0.1 0 0 0 0.8 0.2 0.5 0 0.4 12.5 0 0 0\n" +
        wall);
    ASSERT_EQ(picture.pixels.size(), std::size_t{width} * height);
    const double right = std::tan(std::numbers::pi / 6), up = std::tan(25 * std::numbers::pi / 180);
    for (int j = 0; j < height; ++j)
        for (int i = 0; i < width; ++i) {
            const Vec3 d =
                normalised({right * (2 * (i + 0.5) / width - 1), up * (1 - 2 * (j + 0.5) / height), -1});
            const double c = -d.z, phong = std::pow(2 * c * c - 1, 12.5);
            const Colour got = picture.pixels[static_cast<std::size_t>(j * width + i)];
            EXPECT_NEAR(got.r, 0.1 + 0.5 * 0.5 * phong, halfStep) << i << "," << j;
            EXPECT_NEAR(got.g, 0.5 * 0.8 * c, halfStep) << i << "," << j;
            EXPECT_NEAR(got.b, 0.5 * (0.2 * c + 0.4 * phong), halfStep) << i << "," << j;
        }
}

TEST_F(Povray, DimsAllLightByTheExposure) {
    writeFile(std::filesystem::path(YARTE_TEST_OUTPUT) / "exposure.yarte",
              look + "material 3 0.2 0.3 0 0 0 0 0 0 1 0.5 0 0\n" + wall);
    Options wanted = options(std::filesystem::path(YARTE_TEST_OUTPUT) / "exposure.yarte", "scene.pov");
    wanted.writing.exposure = 0.25;
    expectEverywhere(render(wanted), {3.25 / 4, 0.325 / 4, 0.3625 / 4});
}

} // namespace
} // namespace yarte::convert::test
