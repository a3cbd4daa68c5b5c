// Whole outputs beside their inputs in golden/. After a wanted change, look at what the test left and copy it
// there.
#include "tests/convert/support.h"
#include "yarte/base/file.h"

#include <gtest/gtest.h>

#include <cmath>

namespace yarte::convert::test {
namespace {

struct Golden {
    const char *input, *expected;
    bool plain;
};

void PrintTo(const Golden& golden, std::ostream* out) { *out << golden.expected; }

class GoldenSdl : public testing::TestWithParam<Golden> {};

TEST_P(GoldenSdl, IsAsExpected) {
    const std::filesystem::path got =
        std::filesystem::path(YARTE_TEST_OUTPUT) / "convert" / GetParam().expected;
    Options wanted = options(goldenFolder / GetParam().input, got);
    wanted.writing.plainTextures = GetParam().plain;
    const Converted run(wanted);
    ASSERT_EQ(run.files.size(), 1U) << run.problems();
    EXPECT_EQ(run.files[0].file, got);
    std::filesystem::create_directories(got.parent_path());
    writeFile(got, run.files[0].bytes);
    const std::filesystem::path expected = goldenFolder / GetParam().expected;
    EXPECT_EQ(run.files[0].bytes, readFile(expected)) << "compare " << got << " with " << expected;
}

INSTANTIATE_TEST_SUITE_P(, GoldenSdl,
                         testing::Values(Golden{"shapes.yarte", "shapes.pov", false},
                                         Golden{"planes.yarte", "planes.pov", false},
                                         Golden{"tints.yarte", "tints.pov", false},
                                         Golden{"tints.yarte", "tints_plain.pov", true},
                                         Golden{"meshes.yarte", "meshes.pov", false},
                                         Golden{"meshes.yarte", "meshes_plain.pov", true}));

TEST(Sdl, GivesTheSameBytesForTheSameScene) {
    const Converted first(options(goldenFolder / "meshes.yarte", "a.pov")),
        second(options(goldenFolder / "meshes.yarte", "b.pov"));
    ASSERT_EQ(first.files.size(), 1U);
    ASSERT_EQ(second.files.size(), 1U);
    EXPECT_EQ(first.files[0].bytes, second.files[0].bytes);
}

TEST(Sdl, LosesNothing) {
    const Converted run(options(goldenFolder / "shapes.yarte", "a.pov"));
    EXPECT_EQ(summary(run.ledger), "image|resolution and gamma|extras\n"
                                   "camera|everything|exact\n"
                                   "lights|everything|exact\n"
                                   "bodies|shape and place|exact\n"
                                   "material 1|everything|exact\n"
                                   "material 2|everything|exact\n");
    EXPECT_EQ(run.problems(), "");
}

TEST(Sdl, SaysWherePlanesEnd) {
    const Converted run(options(goldenFolder / "planes.yarte", "a.pov"));
    ASSERT_TRUE(run.ledger.hasLoss()) << run.problems();
    const LedgerRow& row = run.ledger.rows().back();
    EXPECT_EQ(row.where, "body 3");
    EXPECT_EQ(row.property, "extent");
    EXPECT_EQ(row.action, Action::approximated);
}

TEST(Sdl, SaysHowFarAPolygonIsFromItsPlane) {
    const std::filesystem::path file = std::filesystem::path(YARTE_TEST_OUTPUT) / "convert" / "bent.yarte";
    std::filesystem::create_directories(file.parent_path());
    writeFile(file,
              "camera_position 0 0 5\nfocus_point 0 0 0\nlight_source 1 1 1 1\n"
              "material 1 1 1 1 1 1 0 0 0 1 0 0 0\npolygon 4 0 0 0.001 2 0 -0.001 2 2 0.001 0 2 -0.001\n");
    const Converted run(options(file, "a.pov"));
    ASSERT_TRUE(run.ledger.hasLoss()) << run.problems();
    const LedgerRow& row = run.ledger.rows().back();
    EXPECT_EQ(row.where, "body 1");
    EXPECT_EQ(row.action, Action::approximated);
    EXPECT_NEAR(row.bound.value(), 0.001 / std::sqrt(8.0),
                1e-8); // the size is twice the distance from the mean
}

} // namespace
} // namespace yarte::convert::test
