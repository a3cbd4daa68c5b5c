// The table of formats.
#include "convert/format.h"

#include <gtest/gtest.h>

namespace yarte::convert {
namespace {

TEST(Formats, AreListed) {
    EXPECT_EQ(listFormats(), "yarte   .yarte        read, write\n"
                             "pmf     .pmf          read, write\n"
                             "gltf    .gltf         read, write\n"
                             "glb     .glb          read, write\n"
                             "pov     .pov          read, write\n");
}

TEST(Formats, AreFoundByExtensionInAnyCase) {
    ASSERT_NE(formatOf("a/b.c/SCENE.Yarte"), nullptr);
    EXPECT_EQ(formatOf("a/b.c/SCENE.Yarte")->name, "yarte");
    EXPECT_EQ(formatOf("x.PMF")->name, "pmf");
    EXPECT_EQ(formatOf("x.yarte.bak"), nullptr);
    EXPECT_EQ(formatOf("pov"), nullptr);
    EXPECT_EQ(formatOf(""), nullptr);
}

TEST(Formats, AreFoundByName) {
    ASSERT_NE(formatNamed("pov"), nullptr);
    EXPECT_NE(formatNamed("pov")->read, nullptr);
    EXPECT_EQ(formatNamed(".pov"), nullptr);
    EXPECT_EQ(formatNamed(""), nullptr);
}

} // namespace
} // namespace yarte::convert
