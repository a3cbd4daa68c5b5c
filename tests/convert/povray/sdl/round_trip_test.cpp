// YARTE -> POV-Ray -> YARTE is the identical canonical text, for our scenes and for random ones.
#include "tests/convert/round_trip.h"
#include "tests/convert/support.h"
#include "tests/lang/random_scene.h"

#include "convert/povray/sdl/read.h"
#include "convert/povray/write.h"

#include <gtest/gtest.h>

namespace yarte::convert::test {
namespace {

struct Conversions {
    Sources sources;
    Diagnostics diagnostics;
    Ledger ledger;

    Conversion of(const std::string& text) {
        return {{sources.add("scene.pov", text), "scene.pov", {}}, "out", {}, sources, diagnostics, ledger};
    }
};

std::string asSdl(const Scene& scene) {
    Conversions c;
    Conversion conversion = c.of("");
    return povray::writeScene(scene, conversion).front().bytes;
}

void expectSame(const Scene& scene, const std::string& what) {
    Conversions c;
    Conversion conversion = c.of(asSdl(scene));
    const auto back = povray::readScene(conversion);
    ASSERT_TRUE(back) << what << '\n' << format(c.diagnostics, c.sources, DiagnosticStyle::plain);
    EXPECT_EQ(everything(*back), everything(scene)) << what;
}

TEST(SdlRoundTrip, EverySceneOfOursIsTheSameText) {
    forEachSceneOfOurs([](const Scene& scene, const std::string& name) { expectSame(scene, name); });
}

class SdlRoundTripOf : public testing::TestWithParam<unsigned> {};

TEST_P(SdlRoundTripOf, ARandomSceneIsTheSameText) {
    for (unsigned i = 0; i < 25; ++i) {
        const unsigned seed = 25 * GetParam() + i;
        expectSame(yarte::test::SceneMaker(seed).make(), "seed " + std::to_string(seed));
    }
}

INSTANTIATE_TEST_SUITE_P(Seeds, SdlRoundTripOf, testing::Range(0u, 4u));

/// What a file shows is what it means.
TEST(SdlRoundTrip, AnEditedFileMeansWhatItShows) {
    Scene scene;
    scene.camera.position = {0, 0, 10};
    scene.materials = {{{0, 0, 0}, {1, 0, 0}, {0, 0, 0}}};
    scene.bodies = {{Sphere{{1, 2, 3}, 0.1}, {0}, {}, {}}};
    std::string text = asSdl(scene);
    const auto edit = [&](const std::string& from, const std::string& to) {
        const std::size_t at = text.find(from);
        ASSERT_NE(at, std::string::npos) << from << '\n' << text;
        text.replace(at, from.size(), to);
    };
    edit("<1, 2, 3>*World_Scale", "<1, 2, 4>*World_Scale");
    edit("<1, 0, 0>", "<0, 1, 0>"); // the diffuse colour
    Conversions c;
    Conversion conversion = c.of(text);
    const auto back = povray::readScene(conversion);
    ASSERT_TRUE(back) << format(c.diagnostics, c.sources, DiagnosticStyle::plain);
    EXPECT_EQ(std::get<Sphere>(back->bodies[0].shape).centre, (Vec3{1, 2, 4}));
    EXPECT_EQ(back->materials[0].diffuse, (Colour{0, 1, 0}));
}

} // namespace
} // namespace yarte::convert::test
