#include "validate/exr_header.h"
#include "validate/image_file.h"
#include "validate/png_chunks.h"

#include "tests/validate/support.h"
#include "yarte/base/srgb.h"

#include <cstring>
#include <gmock/gmock.h>

namespace yarte::validate {
namespace {

using test::scratchFolder;

std::string floatBytes(std::initializer_list<float> values) {
    std::string bytes(values.size() * sizeof(float), '\0');
    std::memcpy(bytes.data(), values.begin(), bytes.size());
    return bytes;
}

TEST(ImageFile, PfmIsFloatingPointWithTheLowestRowFirst) {
    const auto file = scratchFolder() / "p.pfm";
    writeFile(file, "PF\n1 2\n-1.0\n" + floatBytes({1.5f, -0.25f, 1e-8f, 3, 4, 5}));
    const Picture picture = readPicture(file, Encoding::srgb); // floats are linear all the same
    EXPECT_EQ(picture.width, 1);
    EXPECT_EQ(picture.height, 2);
    EXPECT_EQ(picture.pixels, (std::vector<Colour>{{3, 4, 5}, {1.5f, -0.25f, 1e-8f}}));
}

TEST(ImageFile, PngsComeBackExactly) {
    const auto file = scratchFolder() / "p.png";
    DisplayPicture display{256, 1, {}};
    for (int v = 0; v < 256; ++v)
        for (const int channel : {v, 255 - v, 7}) display.rgb.push_back(static_cast<std::uint8_t>(channel));
    writeFile(file, encodePng(display));
    const Picture linear = readPicture(file), decoded = readPicture(file, Encoding::srgb);
    for (int v = 0; v < 256; ++v) {
        const auto i = static_cast<std::size_t>(v);
        ASSERT_EQ(linear.pixels[i], (Colour{v / 255.0, (255 - v) / 255.0, 7 / 255.0}));
        ASSERT_EQ(decoded.pixels[i].r, linearFromSrgb(v / 255.0));
    }
}

TEST(ImageFile, ThePngOfAPictureIsItsSrgbEncoding) {
    // 0.5 linear is 0.735357 in sRGB: 187.5 of 255.
    const DisplayPicture shown = displayPicture(Picture{1, 2, {{0.5, 0, 1}, {-1, 2, 0.0031308}}}.view());
    EXPECT_THAT(shown.rgb, testing::ElementsAre(188, 0, 255, 0, 255, 10));
}

TEST(ImageFile, DifferencesAreGreyUpToTheThresholdAndColouredAbove) {
    const Picture black = test::constantPicture(4, 1, {});
    const double threshold = 1.0 / 4096;
    const Picture other{4, 1, {{}, {0, 1.0 / 4096, 0}, {0, 0, 1}, {1.0 / 131072, 0, 0}}};
    const auto rgb = differencePicture(other.view(), black.view(), threshold).rgb;
    // 1/4096 lies 5 of 17 doublings above 2^-17.
    EXPECT_THAT(rgb, testing::ElementsAre(0, 0, 0, 75, 75, 75, 255, 255, 26, 0, 0, 0));
}

TEST(ImageFile, WhatCannotBeReadIsNamed) {
    const auto folder = scratchFolder();
    writeFile(folder / "text.png", "not a picture");
    writeFile(folder / "short.ppm", "P6\n2 2\n255\n123");
    for (const char* name : {"missing.png", "text.png", "short.ppm", "."}) {
        try {
            readPicture(folder / name);
            ADD_FAILURE() << name << " was read";
        } catch (const ImageError& error) {
            EXPECT_THAT(error.what(), testing::StartsWith((folder / name).string() + ": "));
        }
    }
}

TEST(ImageFile, AFewBytesAreNoLargePicture) {
    const auto file = scratchFolder() / "p.pfm";
    writeFile(file, "PF\n30000 30000\n-1.0\n" + floatBytes({1, 2, 3}));
    try {
        readPicture(file);
        ADD_FAILURE() << "was read";
    } catch (const ImageError& error) {
        EXPECT_THAT(error.what(),
                    testing::HasSubstr("30000x30000 pixels are too many for a file of 32 bytes"));
    }
    EXPECT_THROW(readLayers(file), ImageError);
}

TEST(ImageFile, AnOpenExrFileHasTheAttributesOfItsHeader) {
    using namespace std::string_literals;
    const auto attribute = [](std::int32_t size, const std::string& value,
                              const std::string& type = "string") {
        std::string bytes = "name\0"s + type + '\0';
        bytes.append(reinterpret_cast<const char*>(&size), sizeof size);
        return bytes + value;
    };
    const std::string one = "\x76\x2f\x31\x01\x02\0\0\0"s, many = "\x76\x2f\x31\x01\x02\x10\0\0"s;
    EXPECT_TRUE(exrAttributesFit(one + attribute(3, "abc") + attribute(1, "d") + "\0"s));
    EXPECT_FALSE(exrAttributesFit(one + attribute(3, "abc") + attribute(1, "d"))) << "nothing ends it";
    EXPECT_FALSE(exrAttributesFit(one + attribute(3, "ab")));
    EXPECT_FALSE(exrAttributesFit(one + attribute(0x7fffffff, "abc") + "\0"s));
    EXPECT_FALSE(exrAttributesFit(one + attribute(-1, "abc") + "\0"s));
    EXPECT_FALSE(exrAttributesFit(one + "name"));
    EXPECT_FALSE(exrAttributesFit(one.substr(0, 6)));
    EXPECT_TRUE(exrAttributesFit(many + attribute(1, "a") + "\0"s + attribute(1, "b") + "\0\0"s));
    EXPECT_FALSE(exrAttributesFit(many + attribute(1, "a") + "\0"s + attribute(2, "b")));
    EXPECT_TRUE(exrAttributesFit("not OpenEXR at all"));

    const auto isRight = [&](const std::string& type, const std::string& value) {
        return exrAttributesFit(one + attribute(static_cast<std::int32_t>(value.size()), value, type) +
                                "\0"s);
    };
    EXPECT_TRUE(isRight("v2f", "12345678"));
    EXPECT_FALSE(isRight("v2f", "123456789"));
    EXPECT_TRUE(isRight("chlist", "R\0"s + std::string(16, 'x') + "\0"s));
    EXPECT_FALSE(isRight("chlist", "R\0"s + std::string(16, 'x')));
    EXPECT_FALSE(isRight("chlist", "R\0"s + std::string(15, 'x') + "\0"s));
    EXPECT_FALSE(isRight("chlist", "\0x"s));
    EXPECT_TRUE(isRight("stringvector", "\2\0\0\0ab\0\0\0\0"s));
    EXPECT_FALSE(isRight("stringvector", "\3\0\0\0ab"s));
    EXPECT_TRUE(isRight("preview", "\1\0\0\0\2\0\0\0rgbargba"s));
    EXPECT_FALSE(isRight("preview", "\1\0\0\0\3\0\0\0rgbargba"s));
    EXPECT_TRUE(isRight("unheard-of", "12345"));

    const auto file = scratchFolder() / "p.exr";
    writeFile(file, one + attribute(0x7fffffff, "abc") + "\0"s);
    try {
        readPicture(file);
        ADD_FAILURE() << "was read";
    } catch (const ImageError& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("it says that it has more than there is"));
    }
}

TEST(ImageFile, APngFileHasItsChunks) {
    using namespace std::string_literals;
    const std::string png = "\x89PNG\r\n\x1a\n";
    const auto chunk = [](char length, const std::string& type, const std::string& data) {
        return "\0\0\0"s + length + type + data + "CRC.";
    };
    const std::string head = png + chunk(2, "IHDR", "ab"), end = chunk(0, "IEND", "");
    EXPECT_TRUE(pngChunksFit(head + end));
    EXPECT_TRUE(pngChunksFit(head + end + "more"));
    EXPECT_FALSE(pngChunksFit(head + end.substr(0, 9)));
    EXPECT_FALSE(pngChunksFit(head + chunk(3, "zTXt", "ab")));
    EXPECT_FALSE(pngChunksFit(head + "\x7f\xff\xff\xffzTXt" + "abCRC." + end));
    EXPECT_TRUE(pngChunksFit("not PNG at all"));
}

TEST(ImageFile, IsReadAsWhatItsNameSays) {
    const auto folder = scratchFolder();
    writeFile(folder / "p.pfm", "PF\n1 1\n-1.0\n" + floatBytes({1, 2, 3}));
    EXPECT_EQ(readPicture(folder / "p.pfm").pixels[0].b, 3);
    for (const char* name : {"p.png", "p.exr", "p.raw", "p.unheard-of", "p"}) {
        writeFile(folder / name, "PF\n1 1\n-1.0\n" + floatBytes({1, 2, 3}));
        EXPECT_THROW(readPicture(folder / name), ImageError) << name;
    }
}

TEST(Srgb, DecodingUndoesEncoding) {
    for (int i = 0; i <= 1000; ++i) ASSERT_NEAR(linearFromSrgb(srgbFromLinear(i / 1000.0)), i / 1000.0, 1e-6);
}

} // namespace
} // namespace yarte::validate
