// Every expected value is a pixel that POV-Ray 3.7.0.10 showed of a wall that fills the picture, before a
// background of <0.5, 0.25, 0.125>, lit at right angles by <1, 0.9, 0.8>.
#include "convert/povray/sdl/reduce_layers.h"

#include "tests/convert/povray/sdl/support.h"

#include <gtest/gtest.h>

#include <cmath>

namespace yarte::convert::povray::sdl::test {
namespace {

constexpr double tolerance = 2e-5; // of the 16-bit picture

const Rgbft clear{0.8, 0.6, 0.4, 0.3, 0.2};

/// What YARTE shows of such a wall.
Colour shown(const Material& m) {
    const Colour background{0.5, 0.25, 0.125}, light{1, 0.9, 0.8};
    return m.ambient + light * (m.diffuse + m.specular) + background * m.reflection +
           background * transmittance(m);
}

void expectShown(const Layers& layers, double version, Colour passes, Colour expected) {
    const Surface s = reduce(layers, nullptr, {{1, 1, 1}, version});
    const Colour passed = transmittance(s.material);
    EXPECT_NEAR(passed.r, passes.r, 1e-12);
    EXPECT_NEAR(passed.g, passes.g, 1e-12);
    EXPECT_NEAR(passed.b, passes.b, 1e-12);
    const Colour got = shown(s.material);
    EXPECT_NEAR(got.r, expected.r, tolerance) << version;
    EXPECT_NEAR(got.g, expected.g, tolerance) << version;
    EXPECT_NEAR(got.b, expected.b, tolerance) << version;
}

const Colour tint{0.44, 0.38, 0.32}; // rgb*filter + transmit of `clear`

TEST(ReduceLayers, DimsLocalTermsByFilterAndTransmit) {
    expectShown({plain(clear, 0.5, 0)}, 3.7, tint, {0.42, 0.245, 0.14});
    expectShown({plain(clear, 0, 0.7)}, 3.7, tint, {0.50001, 0.284, 0.152});
    for (const double version : {3.0, 3.1, 3.5, 3.62}) {
        expectShown({plain(clear, 0.5, 0)}, version, tint, {0.44401, 0.263, 0.152});
        expectShown({plain(clear, 0, 0.7)}, version, tint, {0.53359, 0.30668, 0.16544});
    }
    Texture emitting = plain(clear, 0, 0);
    emitting.finish.emission = {0.3, 0.3, 0.3};
    expectShown({emitting}, 3.7, tint, {0.34, 0.185, 0.1});
    expectShown({emitting}, 3.5, tint, {0.35441, 0.1958, 0.10719});
}

TEST(ReduceLayers, KeepsHighlightsAndMirrorsUndimmed) {
    Texture shiny = plain(clear, 0, 0);
    shiny.finish.phong = 0.3, shiny.finish.phongSize = 10;
    expectShown({shiny}, 3.7, tint, {0.52, 0.365, 0.28});
    EXPECT_EQ(reduce({shiny}, nullptr, {}).material.exponent, 10);
    Texture mirror = plain(clear, 0, 0);
    mirror.finish.reflectionMin = mirror.finish.reflectionMax = {0.3, 0.3, 0.3};
    expectShown({mirror}, 3.7, tint, {0.37, 0.17, 0.0775});
    mirror.pigment.colour = {0.8, 0.6, 0.4, 0, 0.5};
    mirror.finish.ambient = {0.3, 0.3, 0.3}, mirror.finish.diffuse = 0.5, mirror.finish.conserveEnergy = true;
    mirror.finish.reflectionMin = mirror.finish.reflectionMax = {0.5, 0.5, 0.5};
    expectShown({mirror}, 3.7, {0.25, 0.25, 0.25}, {0.695, 0.4125, 0.23375});
}

TEST(ReduceLayers, SeesLowerLayersThroughUpperOnes) {
    const Layers overOpaque{plain({0.9, 0.8, 0.7, 0, 0}, 0.5, 0), plain(clear, 0.2, 0)};
    expectShown(overOpaque, 3.7, {}, {0.278, 0.212, 0.152});
    expectShown(overOpaque, 3.5, {}, {0.2876, 0.2192, 0.1568});
    expectShown(overOpaque, 3.1, {}, {0.305, 0.26, 0.215});
    const Layers overClear{plain({0.9, 0.8, 0.7, 0.4, 0.1}, 0.5, 0), plain(clear, 0.2, 0)};
    const Colour lower{0.46, 0.42, 0.38};
    expectShown(overClear, 3.7, lower * tint, {0.2802, 0.17591, 0.11119});
    expectShown(overClear, 3.5, lower * tint, {0.29772, 0.18918, 0.12049});
    expectShown(overClear, 3.1, lower * 0.5, {0.3165, 0.22049, 0.15825});
    Texture shiny = plain({0.5, 0.5, 0.5, 0, 0}, 0, 0);
    shiny.finish.phong = 0.3;
    const Layers overShiny{shiny, plain({0.2, 0.4, 0.6, 0.5, 0}, 0, 0)};
    expectShown(overShiny, 3.7, {}, {0.03, 0.054, 0.07201});
    expectShown(overShiny, 3.1, {}, {0.15, 0.135, 0.12});
}

TEST(ReduceLayers, SeesNothingBelowAnOpaqueLayer) {
    Texture mirror = plain({0.5, 0.5, 0.5, 0, 0}, 0, 0);
    mirror.finish.reflectionMin = mirror.finish.reflectionMax = {0.3, 0.3, 0.3};
    expectShown({mirror, plain({0.2, 0.2, 0.2, 0, 0}, 0.5, 0)}, 3.7, {}, {0.1, 0.1, 0.1});
}

TEST(ReduceLayers, TellsWhatIsNotTheSame) {
    const auto told = [](const Texture& t, const Interior* interior = nullptr) {
        std::string text;
        for (const Loss& loss : reduce({t}, interior, {}).losses) text += loss.property + ";";
        return text;
    };
    EXPECT_EQ(told(plain({1, 0, 0, 0, 0})), "");
    EXPECT_EQ(told(plain({1, 1, 1, 0, 0.5})), "levels;");
    EXPECT_EQ(told(plain({1, 0, 1, 0.5, 0})), "levels;");
    const Interior glass{1.5, {}};
    EXPECT_EQ(told(plain({1, 1, 1, 0, 0.5}), &glass), "");
    Texture mirroring = plain({1, 1, 1, 0, 0.5});
    mirroring.finish.reflectionMin = mirroring.finish.reflectionMax = {0.3, 0.3, 0.3};
    EXPECT_EQ(told(mirroring, &glass), "total internal reflection;");
    EXPECT_EQ(reduce({plain({1, 1, 1, 0, 0.5})}, &glass, {}).material.index, 1.5);
    Texture t = plain({1, 0, 0, 0, 0});
    t.finish.specular = 0.5, t.finish.phong = 0.2, t.finish.metallic = 1, t.finish.brilliance = 2;
    t.finish.ignored = {"crand"}, t.hasNormal = true, t.pigment.pattern = "checker", t.kind = "texture_map";
    EXPECT_EQ(told(t), "texture;pigment;normal;crand;specular;metallic;brilliance;highlights;");
    // filter + transmit above 1 leave a negative rest
    const Surface dark = reduce({plain({1, 1, 1, 0.7, 0.6}, 0.5, 0)}, nullptr, {});
    EXPECT_EQ(dark.material.ambient, Colour());
    EXPECT_NEAR(*dark.losses.back().bound, 0.15, 1e-12);
}

TEST(ReduceLayers, TakesMeansOfReflectionsByAngle) {
    Texture t = plain({1, 1, 1, 0, 0}, 0, 0);
    t.finish.reflectionMin = {0.1, 0.1, 0.1}, t.finish.reflectionMax = {0.7, 0.7, 0.7};
    const Surface linear = reduce({t}, nullptr, {});
    EXPECT_NEAR(linear.material.reflection, 0.1 + 0.6 / 3, 1e-12);
    EXPECT_NEAR(linear.losses.at(0).bound.value(), 0.4, 1e-12);
    t.finish.reflectionFresnel = true;
    const Interior glass{1.5, {}};
    // The mean reflectance of a dielectric of index 1.5 under diffuse light is 0.0918 [Walsh 1926].
    EXPECT_NEAR(reduce({t}, &glass, {}).material.reflection, 0.1 + 0.6 * 0.0918, 1e-4);
}

} // namespace
} // namespace yarte::convert::povray::sdl::test
