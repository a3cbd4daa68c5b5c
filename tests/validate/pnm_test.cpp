#include "validate/pnm.h"

#include "tests/validate/support.h"

namespace yarte::validate {
namespace {

using namespace std::string_literals;

TEST(Pnm, EverySixteenBitValueIsExact) {
    std::string bytes = "P6\n256 256\n65535\n";
    for (int v = 0; v < 65536; ++v)
        for (int channel = 0; channel < 3; ++channel) {
            bytes += static_cast<char>(v >> 8);
            bytes += static_cast<char>(v);
        }
    const Picture picture = readPnm(bytes);
    ASSERT_EQ(picture.pixels.size(), 65536u);
    for (int v = 0; v < 65536; ++v)
        ASSERT_EQ(picture.pixels[static_cast<std::size_t>(v)],
                  (Colour{v / 65535.0, v / 65535.0, v / 65535.0}));
}

TEST(Pnm, ChannelsRowsCommentsAndOtherLargestValues) {
    const Picture picture = readPnm("P6 # a comment\n2\t1\n# another\n100 \x00\x32\x64\x01\x02\x03"s);
    EXPECT_EQ(picture.width, 2);
    EXPECT_EQ(picture.height, 1);
    EXPECT_EQ(picture.pixels, (std::vector<Colour>{{0, 0.5, 1}, {0.01, 0.02, 0.03}}));
}

TEST(Pnm, GreyHasThreeEqualChannels) {
    const Picture picture = readPnm("P5\n1 2\n300\n\x00\x96\x01\x2c"s);
    EXPECT_EQ(picture.pixels, (std::vector<Colour>{{0.5, 0.5, 0.5}, {1, 1, 1}}));
}

TEST(Pnm, KnowsItsFiles) {
    EXPECT_TRUE(isBinaryPnm("P6\n1 1\n255\n"));
    EXPECT_TRUE(isBinaryPnm("P5 1 1 255 "));
    EXPECT_FALSE(isBinaryPnm("P3\n1 1\n255\n"));
    EXPECT_FALSE(isBinaryPnm("PF\n1 1\n-1.0\n"));
    EXPECT_FALSE(isBinaryPnm("P6"));
    EXPECT_FALSE(isBinaryPnm(""));
}

std::string errorOf(const std::string& bytes) {
    try {
        readPnm(bytes);
    } catch (const PnmError& error) {
        return error.what();
    }
    return "";
}

TEST(Pnm, BrokenFilesAreErrors) {
    EXPECT_EQ(errorOf("P6\n2 2\n255\n123"), "it ends after 3 of 12 bytes of pixels");
    EXPECT_EQ(errorOf("P6\n1000000 1000000\n65535\n"), "it ends after 0 of 6000000000000 bytes of pixels");
    for (const char* header :
         {"P6\n", "P6\n# only", "P6\n-1 2\n255\n", "P6\n0 2\n255\n", "P6\n99999999999 2\n255\n"})
        EXPECT_EQ(errorOf(header), "its header needs numbers from 1 to 1000000") << header;
    EXPECT_EQ(errorOf("P6\n1 1\n65536\n123456"), "its header needs numbers from 1 to 65535");
}

} // namespace
} // namespace yarte::validate
