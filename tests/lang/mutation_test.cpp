// Damaged inputs never crash the readers, and always give either a result or an error.
#include "tests/lang/random_scene.h"
#include "tests/lang/read_text.h"

#include "yarte/lang/scene_printer.h"

#include <gtest/gtest.h>

namespace yarte {
namespace {

/// Changes a text in one to eight places.
std::string mutated(std::string text, test::Random& random) {
    static const std::string pieces[] = {"\"",
                                         ";",
                                         "\n",
                                         "-",
                                         "1e999",
                                         " nan ",
                                         "0",
                                         " sphere ",
                                         " mesh ",
                                         "\xFF",
                                         "\xE2\x82",
                                         "4294967296",
                                         " polygon 3 ",
                                         "9999999999",
                                         "normals 3\n",
                                         "\r",
                                         std::string(1, '\0')};
    for (int i = 1 + random.below(8); i > 0 && !text.empty(); --i) {
        const auto at = static_cast<std::size_t>(random.below(static_cast<int>(text.size())));
        const auto length = static_cast<std::size_t>(random.below(20));
        switch (random.below(5)) {
        case 0: text.erase(at, length); break;
        case 1: text.insert(at, pieces[random.below(std::size(pieces))]); break;
        case 2: text[at] = static_cast<char>(random.below(256)); break;
        case 3:
            text.insert(at, text.substr(static_cast<std::size_t>(random.below(static_cast<int>(text.size()))),
                                        length));
            break;
        default:
            if (random.below(5) == 0) text.resize(at);
        }
    }
    return text;
}

TEST(Mutation, ScenesAreReadOrRefused) {
    int good = 0, bad = 0;
    for (unsigned seed = 0; seed < 2000; ++seed) {
        test::Random random(seed);
        const test::SceneText read(mutated(printScene(test::SceneMaker(seed % 50).make()), random));
        ASSERT_EQ(read.scene.has_value(), !read.diagnostics.hasErrors()) << "seed " << seed << "\n"
                                                                         << read.messages();
        for (const DiagnosticStyle style : {DiagnosticStyle::coloured, DiagnosticStyle::json})
            ASSERT_EQ(format(read.diagnostics, read.sources, style).empty(), read.diagnostics.all().empty());
        ++(read.scene ? good : bad);
        if (read.scene) { // what is accepted can be printed and read again
            const std::string text = printScene(*read.scene);
            ASSERT_EQ(printScene(test::SceneText(text).scene.value()), text) << "seed " << seed;
        }
    }
    EXPECT_GT(good, 20);
    EXPECT_GT(bad, 1000);
}

TEST(Mutation, MeshesAreReadOrRefused) {
    const std::filesystem::path folder =
        std::filesystem::path(YARTE_SOURCE_DIR) / "tests" / "data" / "lang" / "good";
    const std::string meshes[] = {readFile(folder / "cube.pmf"), readFile(folder / "smooth.pmf")};
    int good = 0, bad = 0;
    for (unsigned seed = 0; seed < 2000; ++seed) {
        test::Random random(seed);
        const test::PmfText read(mutated(meshes[seed % 2], random));
        ASSERT_EQ(read.mesh.has_value(), !read.diagnostics.hasErrors()) << "seed " << seed << "\n"
                                                                        << read.messages();
        ++(read.mesh ? good : bad);
        if (read.mesh) {
            ASSERT_EQ(test::PmfText(printPmf(*read.mesh)).mesh, read.mesh) << "seed " << seed;
        }
    }
    EXPECT_GT(good, 20);
    EXPECT_GT(bad, 1000);
}

} // namespace
} // namespace yarte
