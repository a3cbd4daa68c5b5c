// The labelled scenes: small pictures that say in comments what is true of them, and why.
//
//     ;= pixel X Y R G B within E    that pixel's colour, each channel
//     ;= all R G B within E          every pixel's
//     ;= none R G B                  no pixel has exactly this colour
//     ;= error CODE                  the scene is refused with this one error
#include "tests/support/program.h"

#include "yarte/base/file.h"
#include "yarte/lang/pmf.h"
#include "yarte/lang/scene_reader.h"
#include "yarte/trace/render_tile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>

using namespace yarte;

namespace {

namespace fs = std::filesystem;

const fs::path folder = fs::path(YARTE_SOURCE_DIR) / "tests" / "hard" / "scenes";

std::vector<fs::path> sceneFiles() {
    std::vector<fs::path> result;
    for (const auto& entry : fs::directory_iterator(folder))
        if (entry.path().extension() == ".yarte") result.push_back(entry.path());
    std::sort(result.begin(), result.end());
    return result;
}

struct Truth {
    std::string kind, code; ///< the words after ";="
    int x = 0, y = 0;
    Colour colour;
    double within = 0;
};

std::vector<Truth> truthsIn(const std::string& text) {
    std::vector<Truth> truths;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        if (!line.starts_with(";= ")) continue;
        std::istringstream words(line.substr(3));
        Truth t;
        std::string within;
        words >> t.kind;
        if (t.kind == "error")
            words >> t.code;
        else {
            if (t.kind == "pixel") words >> t.x >> t.y;
            words >> t.colour.r >> t.colour.g >> t.colour.b;
            if (t.kind != "none") words >> within >> t.within;
        }
        EXPECT_TRUE(words && (within.empty() || within == "within")) << line;
        truths.push_back(t);
    }
    return truths;
}

struct Picture {
    Resolution resolution;
    std::vector<Colour> pixels;
    Colour at(int x, int y) const { return pixels[static_cast<std::size_t>(y * resolution.width + x)]; }
};

/// `got` is what is true, in all pixels that it speaks of.
void expectTrue(const Truth& t, const Picture& got) {
    for (int y = 0; y < got.resolution.height; ++y)
        for (int x = 0; x < got.resolution.width; ++x) {
            if (t.kind == "pixel" && (x != t.x || y != t.y)) continue;
            const Colour c = got.at(x, y);
            const double off = std::max(
                {std::abs(c.r - t.colour.r), std::abs(c.g - t.colour.g), std::abs(c.b - t.colour.b)});
            // Where it is not a number, neither holds.
            const bool holds = t.kind == "none" ? off > 0 : off <= t.within;
            ASSERT_TRUE(holds) << "pixel " << x << ' ' << y << " is " << c.r << ' ' << c.g << ' ' << c.b
                               << ", off by " << off << "; true: " << t.kind << ' ' << t.colour.r << ' '
                               << t.colour.g << ' ' << t.colour.b << " within " << t.within;
        }
}

class LabelledScene : public testing::TestWithParam<fs::path> {};

TEST_P(LabelledScene, IsAsItMustBe) {
    const std::string text = readFile(GetParam());
    const std::vector<Truth> truths = truthsIn(text);
    ASSERT_FALSE(truths.empty());
    static constexpr MeshFormat formats[] = {{".pmf", readPmf}};
    Sources sources;
    Diagnostics diagnostics;
    const auto scene =
        parseScene(sources.add(GetParam().string(), text), folder, {{}, formats}, sources, diagnostics);
    std::vector<std::string> errors;
    for (const Diagnostic& d : diagnostics.all())
        if (d.severity == Severity::error) errors.emplace_back(d.code);
    if (truths[0].kind == "error") {
        EXPECT_EQ(errors, std::vector{truths[0].code});
        const auto result = test::run("yarte", {GetParam().string()}, test::emptyTestFolder());
        EXPECT_EQ(result.exitCode, 1);
        EXPECT_NE(result.err.find('[' + truths[0].code + ']'), std::string::npos) << result.err;
        return;
    }
    ASSERT_TRUE(scene && errors.empty()) << errors[0];
    const Resolution resolution = scene->resolution;
    const WorldPtr world = buildWorld(*scene, resolution);
    for (const auto renderer : {&renderTile, &renderTileReference}) {
        Picture picture{resolution, {}};
        picture.pixels.resize(static_cast<std::size_t>(resolution.width * resolution.height));
        RayCounts counts;
        renderer(*world, {0, 0, resolution.width, resolution.height}, picture.pixels.data(),
                 static_cast<std::size_t>(resolution.width), counts);
        for (const Truth& t : truths) expectTrue(t, picture);
    }
}

INSTANTIATE_TEST_SUITE_P(Families, LabelledScene, testing::ValuesIn(sceneFiles()), [](const auto& file) {
    std::string name = file.param.stem().string();
    std::replace_if(
        name.begin(), name.end(), [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); }, '_');
    return name;
});

TEST(LabelledScenes, ThereAreEnough) { EXPECT_GE(sceneFiles().size(), 60U); }

} // namespace
