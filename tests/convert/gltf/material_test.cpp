// glTF's materials as Phong's and back, against values worked out by hand from convert/README.md.
#include "convert/gltf/material_map.h"

#include <gtest/gtest.h>

namespace yarte::convert::gltf {
namespace {

void expectNear(Colour got, Colour expected, double tolerance = 1e-12) {
    EXPECT_NEAR(got.r, expected.r, tolerance);
    EXPECT_NEAR(got.g, expected.g, tolerance);
    EXPECT_NEAR(got.b, expected.b, tolerance);
}

void expectNear(const Material& got, const Material& expected, double tolerance = 1e-12) {
    expectNear(got.ambient, expected.ambient, tolerance);
    expectNear(got.diffuse, expected.diffuse, tolerance);
    expectNear(got.specular, expected.specular, tolerance);
    EXPECT_NEAR(got.exponent, expected.exponent, tolerance * (1 + expected.exponent));
    EXPECT_NEAR(got.reflection, expected.reflection, tolerance);
    EXPECT_NEAR(got.transmission, expected.transmission, tolerance);
    EXPECT_NEAR(got.index, expected.index, tolerance);
    expectNear(got.tint, expected.tint, tolerance);
}

TEST(GltfMaterial, ADielectricScattersAndShines) {
    PbrMaterial m;
    m.base = {0.8, 0.4, 0.2};
    m.metallic = 0;
    m.roughness = 0.5; // n = (16 - 1) / 2 = 7.5
    m.emissive = {0, 0, 0.3};
    // F = (0.5 / 2.5)^2 = 0.04; S = 0.04 * 0.75 * 8.5 / 2 = 0.1275
    expectNear(toPhong(m), {{0.08, 0.04, 0.32}, {0.8, 0.4, 0.2}, {0.1275, 0.1275, 0.1275}, 7.5, 0, 0, 0});
}

TEST(GltfMaterial, AMetalMirrorsAsFarAsItIsSharp) {
    PbrMaterial m;
    m.base = {0.9, 0.6, 0.3};
    m.metallic = 1;
    m.roughness = 0.5;
    // D = b / 4; S = b * 0.75 * 8.5 / 2 = b * 3.1875, scaled to its hue; cr = 0.6 / 4
    expectNear(toPhong(m),
               {{0.09, 0.06, 0.03}, {0.225, 0.15, 0.075}, {1, 2.0 / 3, 1.0 / 3}, 7.5, 0.15, 0, 0});
}

TEST(GltfMaterial, GlassRefractsOnlyWhereItIsThick) {
    PbrMaterial m;
    m.metallic = 0;
    m.roughness = 1; // n = 0, no highlight
    m.transmission = 1;
    m.ior = 1.33;
    expectNear(toPhong(m), {{}, {}, {}, 0, 0, 1, 1});
    m.thickness = 0.1;
    expectNear(toPhong(m), {{}, {}, {}, 0, 0, 1, 1.33});
}

TEST(GltfMaterial, GlassIsTintedByItsBaseColour) {
    PbrMaterial m;
    m.base = {0.2, 0.8, 0.4};
    m.metallic = 0;
    m.roughness = 1;
    m.transmission = 0.5;
    expectNear(toPhong(m), {{0.01, 0.04, 0.02}, {0.1, 0.4, 0.2}, {}, 0, 0, 0.4, 1, {0.25, 1, 0.5}});
    m.alpha = 0.5; // half of the light passes beside it
    expectNear(toPhong(m),
               {{0.005, 0.02, 0.01}, {0.05, 0.2, 0.1}, {}, 0, 0, 0.7, 1, {0.55 / 0.7, 1, 0.6 / 0.7}});
    m.base = {}, m.alpha = 1;
    expectNear(toPhong(m), {{}, {}, {}, 0, 0, 0, 0});
}

TEST(GltfMaterial, UnlitIsAmbientAlone) {
    PbrMaterial m;
    m.base = {0.2, 0.4, 0.6};
    m.unlit = true;
    expectNear(toPhong(m), {{0.2, 0.4, 0.6}, {}, {}, Material().exponent, 0, 0, 0});
}

TEST(GltfMaterial, WhatDoesNotCoverLetsRaysPassStraight) {
    PbrMaterial m;
    m.metallic = 0;
    m.roughness = 1;
    m.alpha = 0.25;
    expectNear(toPhong(m), {{0.025, 0.025, 0.025}, {0.25, 0.25, 0.25}, {}, 0, 0, 0.75, 1});
}

TEST(GltfMaterial, TheSmoothestHasTheLargestExponent) {
    EXPECT_EQ(phongExponent(0), 10000);
    for (const double n : {0.0, 1.0, 33.3, 9999.0})
        EXPECT_NEAR(phongExponent(roughnessOf(n)), n, 1e-9 * (1 + n));
}

/// Phong's opaque materials that glTF can say come back.
TEST(GltfMaterial, WritingIsReadingsInverse) {
    const Material painted{{0.08, 0.05, 0.01}, {0.7, 0.3, 0.1}, {0.2, 0.2, 0.2}, 33.3, 0, 0, 0};
    expectNear(toPhong(toPbr(painted)), painted, 1e-9);
    const Material glass{{0.03, 0.03, 0.03}, {0.2, 0.2, 0.2}, {0.3, 0.3, 0.3}, 50, 0, 0.7, 1.5};
    expectNear(toPhong(toPbr(glass)), glass, 1e-9);
    Material green{{0.02, 0.06, 0.04}, {0.1, 0.3, 0.2}, {0.3, 0.3, 0.3}, 50, 0, 0.6, 1.5};
    green.tint = {1.0 / 3, 1, 2.0 / 3}; // its own colour's hue
    expectNear(toPhong(toPbr(green)), green, 1e-9);
    Material clear{{}, {}, {0.3, 0.3, 0.3}, 50, 0, 0.6, 1.5, {1, 0.5, 0}}; // without any other hue
    const PbrMaterial shown = toPbr(clear);
    expectNear(shown.base, {0.6, 0.3, 0});
    clear.ambient = toPhong(shown).ambient; // viewers' surroundings
    expectNear(toPhong(shown), clear, 1e-9);
}

} // namespace
} // namespace yarte::convert::gltf
