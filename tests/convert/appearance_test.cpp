// Materials in SDL: their names, and what the plain textures lose.
#include "convert/povray/appearance.h"
#include "tests/convert/support.h"

#include <gtest/gtest.h>

namespace yarte::convert::povray {
namespace {

Scene twoMaterials() {
    Scene scene;
    scene.materials = {{{0.1, 0.1, 0.1}, {0.5, 0.5, 0.5}, {0.2, 0.2, 0.2}, 20, 0, 0, 0},
                       {{0.1, 0, 0}, {0, 0.5, 0.5}, {0.2, 0.3, 0.2}, 20, 0.5, 1, 1.5}};
    return scene;
}

TEST(Appearances, AreNamedByMaterialAndByDistinctBack) {
    Scene scene = twoMaterials();
    const BackColours red{{}, {1, 0, 0}, {}}, blue{{}, {0, 0, 1}, {}};
    scene.bodies = {{Sphere{}, {1}, {}, {}}, {Disc{}, {0}, {}, red}, {Disc{}, {0}, {}, blue},
                    {Disc{}, {0}, {}, red},  {Disc{}, {1}, {}, red}, {Disc{}, {0}, {}, {}}};
    const Appearances appearances(scene);
    const char* expected[] = {"Material_2",        "Material_1_Back_1", "Material_1_Back_2",
                              "Material_1_Back_1", "Material_2_Back_1", "Material_1"};
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) EXPECT_EQ(appearances.nameOf(i), expected[i]) << i;
    EXPECT_EQ(
        appearances.declarations(),
        "#declare Material_1 = Yarte_Material(<0.1, 0.1, 0.1>, <0.5, 0.5, 0.5>, <0.2, 0.2, 0.2>, 20, 0, 0, "
        "0)\n"
        "#declare Material_1_Back_1 = Yarte_Two_Sided(<0.1, 0.1, 0.1>, <0.5, 0.5, 0.5>, <0.2, 0.2, 0.2>, "
        "<0, 0, 0>, <1, 0, 0>, <0, 0, 0>, 20, 0, 0, 0)\n"
        "#declare Material_1_Back_2 = Yarte_Two_Sided(<0.1, 0.1, 0.1>, <0.5, 0.5, 0.5>, <0.2, 0.2, 0.2>, "
        "<0, 0, 0>, <0, 0, 1>, <0, 0, 0>, 20, 0, 0, 0)\n"
        "#declare Material_2 = Yarte_Material(<0.1, 0, 0>, <0, 0.5, 0.5>, <0.2, 0.3, 0.2>, 20, 0.5, 1, 1.5)\n"
        "#declare Material_2_Back_1 = Yarte_Two_Sided(<0.1, 0, 0>, <0, 0.5, 0.5>, <0.2, 0.3, 0.2>, "
        "<0, 0, 0>, <1, 0, 0>, <0, 0, 0>, 20, 0.5, 1, 1.5)\n");
}

TEST(Appearances, LoseNothingWhenExact) {
    Ledger ledger;
    reportMaterials(twoMaterials(), false, ledger);
    EXPECT_EQ(test::summary(ledger), "material 1|everything|exact\nmaterial 2|everything|exact\n");
}

TEST(Appearances, SayWhatPlainTexturesLose) {
    Ledger ledger;
    reportMaterials(twoMaterials(), true, ledger);
    EXPECT_EQ(test::summary(ledger), "material 2|specular|approximated\n"
                                     "material 2|diffuse|approximated\n"
                                     "material 2|transmission|approximated\n"
                                     "material 2|ambient and diffuse|dropped\n");
    EXPECT_DOUBLE_EQ(ledger.rows().front().bound.value(), 0.1);
}

} // namespace
} // namespace yarte::convert::povray
