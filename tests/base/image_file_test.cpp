// Each format is read back by a reader that shares nothing with its writer: libpng and OpenEXR themselves, or
// the few lines that the plain formats need.
#include "yarte/base/image_file.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputFile.h>
#include <gtest/gtest.h>
#include <half.h>
#include <png.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace yarte {
namespace {

/// A picture of random colours, some of them below 0 or above 1; the same for the same size.
class Picture {
public:
    Picture(int width, int height) : width_(width), height_(height) {
        std::mt19937 random(static_cast<unsigned>(width * 1000 + height));
        std::uniform_real_distribution<double> values(-0.2, 1.4);
        for (int i = 0; i < width * height; ++i)
            pixels_.push_back({values(random), values(random), values(random)});
    }

    Colour& at(int x, int y) { return pixels_[static_cast<std::size_t>(y * width_ + x)]; }
    ImageView view() const { return {width_, height_, pixels_.data()}; }

private:
    int width_, height_;
    std::vector<Colour> pixels_;
};

int display(double v, int maximum, double gamma) {
    return static_cast<int>(std::floor(maximum * std::pow(std::clamp(v, 0.0, 1.0), 1 / gamma) + 0.5));
}

/// The samples that a png or ppm must hold.
std::vector<int> displayed(ImageView image, int maximum, double gamma) {
    std::vector<int> samples;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            for (const double v : {image.at(x, y).r, image.at(x, y).g, image.at(x, y).b})
                samples.push_back(display(v, maximum, gamma));
    return samples;
}

int byteAt(std::string_view bytes, std::size_t i) { return static_cast<unsigned char>(bytes[i]); }

std::vector<int> samplesOf(std::string_view bytes, int bytesPerSample) {
    std::vector<int> samples;
    for (std::size_t i = 0; i < bytes.size(); i += static_cast<std::size_t>(bytesPerSample))
        samples.push_back(bytesPerSample == 1 ? byteAt(bytes, i)
                                              : byteAt(bytes, i) << 8 | byteAt(bytes, i + 1));
    return samples;
}

struct Png {
    int width = 0, height = 0, depth = 0, colourType = 0;
    bool hasGamma = false, hasTime = false;
    std::vector<int> samples;
};

Png readPng(std::string_view bytes) {
    const auto fail = [](png_structp, png_const_charp message) { throw std::runtime_error(message); };
    const auto read = [](png_structp png, png_bytep to, png_size_t size) {
        auto& rest = *static_cast<std::string_view*>(png_get_io_ptr(png));
        if (rest.size() < size) png_error(png, "too short");
        std::memcpy(to, rest.data(), size);
        rest.remove_prefix(size);
    };
    png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, fail, nullptr);
    png_infop info = png_create_info_struct(png);
    png_set_read_fn(png, &bytes, read);
    png_read_png(png, info, PNG_TRANSFORM_IDENTITY, nullptr);
    Png result{static_cast<int>(png_get_image_width(png, info)),
               static_cast<int>(png_get_image_height(png, info)),
               png_get_bit_depth(png, info),
               png_get_color_type(png, info),
               png_get_valid(png, info, PNG_INFO_gAMA) != 0,
               png_get_valid(png, info, PNG_INFO_tIME) != 0,
               {}};
    for (int y = 0; y < result.height; ++y) {
        const auto* row = reinterpret_cast<const char*>(png_get_rows(png, info)[y]);
        const auto samples = samplesOf({row, png_get_rowbytes(png, info)}, result.depth / 8);
        result.samples.insert(result.samples.end(), samples.begin(), samples.end());
    }
    png_destroy_read_struct(&png, &info, nullptr);
    EXPECT_TRUE(bytes.empty()) << "bytes after the end";
    return result;
}

class MemoryStream : public Imf::IStream {
public:
    explicit MemoryStream(std::string_view bytes) : Imf::IStream("image"), bytes_(bytes) {}
    bool read(char c[], int n) override {
        const auto size = static_cast<std::size_t>(n);
        if (bytes_.size() - position_ < size) throw std::runtime_error("too short");
        std::memcpy(c, bytes_.data() + position_, size);
        position_ += size;
        return position_ < bytes_.size();
    }
    std::uint64_t tellg() override { return position_; }
    void seekg(std::uint64_t position) override { position_ = position; }

private:
    std::string_view bytes_;
    std::size_t position_ = 0;
};

TEST(ImageFormat, IsKnownByTheExtensionInEitherCase) {
    EXPECT_EQ(imageFormat("a.png"), ImageFormat::png);
    EXPECT_EQ(imageFormat("folder.exr/b.PPM"), ImageFormat::ppm);
    EXPECT_EQ(imageFormat("a.b.pfm"), ImageFormat::pfm);
    EXPECT_EQ(imageFormat("a.Exr"), ImageFormat::exr);
    EXPECT_EQ(imageFormat("a.dmp"), ImageFormat::dmp);
    for (const char* file : {"a.jpg", "a", "png", "a.png.txt", ".png", ""})
        EXPECT_EQ(imageFormat(file), std::nullopt);
    EXPECT_EQ(imageExtensions(), ".png .ppm .pfm .exr .dmp");
}

TEST(ImageFormat, OnlyTheDumpLimitsTheSides) {
    EXPECT_TRUE(canHold(ImageFormat::dmp, 65535, 65535));
    EXPECT_FALSE(canHold(ImageFormat::dmp, 65536, 1));
    EXPECT_FALSE(canHold(ImageFormat::dmp, 1, 65536));
    EXPECT_TRUE(canHold(ImageFormat::png, 1000000, 1));
}

TEST(Png, HoldsTheDisplayedSamplesAndNoGammaOrTime) {
    const Picture picture(37, 21);
    for (const int depth : {8, 16})
        for (const bool linear : {false, true}) {
            const ImageEncoding encoding{.gamma = 2.2, .depth = depth, .linear = linear};
            const Png png = readPng(encodePng(picture.view(), encoding));
            EXPECT_EQ(png.width, 37);
            EXPECT_EQ(png.height, 21);
            EXPECT_EQ(png.depth, depth);
            EXPECT_EQ(png.colourType, PNG_COLOR_TYPE_RGB);
            EXPECT_FALSE(png.hasGamma);
            EXPECT_FALSE(png.hasTime);
            EXPECT_EQ(png.samples, displayed(picture.view(), depth == 8 ? 255 : 65535, linear ? 1 : 2.2));
        }
}

TEST(Png, MayBeWiderThanLibpngExpects) {
    const Picture picture(1000001, 1); // libpng's own limit is a million
    const std::string bytes = encodePng(picture.view(), {});
    EXPECT_EQ(bytes.substr(0, 24), std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\x0f\x42\x41\0\0\0\x01", 24));
}

TEST(Ppm, HoldsTheDisplayedSamplesTheHighByteFirst) {
    const Picture picture(5, 3);
    const std::string narrow = encodePpm(picture.view(), {.gamma = 1.8});
    ASSERT_EQ(narrow.substr(0, 11), "P6\n5 3\n255\n");
    EXPECT_EQ(samplesOf(std::string_view(narrow).substr(11), 1), displayed(picture.view(), 255, 1.8));
    const std::string wide = encodePpm(picture.view(), {.gamma = 1.8, .depth = 16, .linear = true});
    ASSERT_EQ(wide.substr(0, 13), "P6\n5 3\n65535\n");
    EXPECT_EQ(samplesOf(std::string_view(wide).substr(13), 2), displayed(picture.view(), 65535, 1));
}

TEST(Pfm, HoldsLinearFloatsFromTheBottomUp) {
    Picture picture(2, 2);
    picture.at(0, 0) = {1.5, -2, 1e300};
    picture.at(1, 1) = {0.1, 0, std::numeric_limits<double>::denorm_min()};
    const std::string bytes = encodePfm(picture.view());
    ASSERT_EQ(bytes.substr(0, 12), "PF\n2 2\n-1.0\n");
    ASSERT_EQ(bytes.size(), 12u + 4 * 3 * 4);
    std::size_t i = 12;
    for (const int y : {1, 0})
        for (const int x : {0, 1})
            for (const double v : {picture.at(x, y).r, picture.at(x, y).g, picture.at(x, y).b}) {
                std::uint32_t bits = 0;
                for (std::size_t k = 0; k < 4; ++k)
                    bits |= static_cast<std::uint32_t>(byteAt(bytes, i++)) << 8 * k;
                EXPECT_EQ(std::bit_cast<float>(bits), static_cast<float>(v));
            }
}

template <class Sample>
void expectExr(const std::string& bytes, const Picture& picture, Imf::PixelType type) {
    MemoryStream stream(bytes);
    Imf::InputFile file(stream);
    const ImageView image = picture.view();
    EXPECT_EQ(file.header().dataWindow(), Imath::Box2i({0, 0}, {image.width - 1, image.height - 1}));
    EXPECT_EQ(file.header().displayWindow(), file.header().dataWindow());
    EXPECT_EQ(file.header().compression(), Imf::ZIP_COMPRESSION);
    EXPECT_EQ(file.header().lineOrder(), Imf::INCREASING_Y);
    const std::size_t count = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    std::vector<Sample> samples[3] = {std::vector<Sample>(count), std::vector<Sample>(count),
                                      std::vector<Sample>(count)};
    const char* names[] = {"R", "G", "B"};
    Imf::FrameBuffer frame;
    for (std::size_t c = 0; c < 3; ++c) {
        ASSERT_TRUE(file.header().channels().findChannel(names[c]));
        EXPECT_EQ(file.header().channels()[names[c]].type, type);
        frame.insert(names[c], Imf::Slice(type, reinterpret_cast<char*>(samples[c].data()), sizeof(Sample),
                                          sizeof(Sample) * static_cast<std::size_t>(image.width)));
    }
    file.setFrameBuffer(frame);
    file.readPixels(0, image.height - 1);
    for (std::size_t i = 0; i < count; ++i) {
        const Colour& colour = image.pixels[i];
        const double expected[] = {colour.r, colour.g, colour.b};
        for (std::size_t c = 0; c < 3; ++c) EXPECT_EQ(samples[c][i], Sample(static_cast<float>(expected[c])));
    }
}

TEST(Exr, HoldsLinearFloatsOrHalves) {
    Picture picture(33, 50); // more than one block of 16 lines, the last one shorter
    picture.at(3, 4) = {2000.5, -3, 1e-3};
    expectExr<float>(encodeExr(picture.view(), {.gamma = 2.2}), picture, Imf::FLOAT);
    expectExr<half>(encodeExr(picture.view(), {.gamma = 2.2, .half = true}), picture, Imf::HALF);
}

TEST(Dmp, IsThePapersTruncatedBytesThroughItsTable) {
    Picture picture(2, 1);
    picture.at(0, 0) = {0.5, 1, 2};      // 127.5 -> 127; 255; clamped
    picture.at(1, 0) = {-1, 0.999, 0.1}; // clamped; 254.7 -> 254; 25.5 -> 25
    EXPECT_EQ(encodeDmp(picture.view(), {}), std::string("\2\0\1\0\x7f\xff\xff\0\xfe\x19", 10));
    EXPECT_EQ(encodeDmp(picture.view(), {.bigEndian = true}),
              std::string("\0\2\0\1\x7f\xff\xff\0\xfe\x19", 10));
    // Gamma 2: 255 sqrt(127/255) = 179.96 -> 179; 255 sqrt(254/255) = 254.4995 -> 254; 255 sqrt(25/255)
    // = 79.8 -> 79.
    EXPECT_EQ(encodeDmp(picture.view(), {.gamma = 2}), std::string("\2\0\1\0\xb3\xff\xff\0\xfe\x4f", 10));
}

TEST(Dmp, IgnoresDepthAndLinear) {
    const Picture picture(4, 4);
    EXPECT_EQ(encodeDmp(picture.view(), {.gamma = 2, .depth = 16, .linear = true}),
              encodeDmp(picture.view(), {.gamma = 2}));
}

TEST(Dmp, KeepsEveryByteWithoutGamma) {
    Picture picture(256, 1);
    for (int c = 0; c < 256; ++c) picture.at(c, 0) = Colour{1, 1, 1} * ((c + 0.5) / 255);
    const std::string bytes = encodeDmp(picture.view(), {.gamma = 1});
    for (int c = 0; c < 256; ++c) EXPECT_EQ(byteAt(bytes, static_cast<std::size_t>(4 + 3 * c)), c);
}

TEST(EncodeImage, NotANumberIsBlackWhereNumbersAreWhole) {
    Picture picture(1, 1);
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    picture.at(0, 0) = {nan, nan, nan};
    EXPECT_EQ(readPng(encodePng(picture.view(), {.gamma = 2})).samples, (std::vector<int>{0, 0, 0}));
    EXPECT_EQ(encodePpm(picture.view(), {}).substr(11), std::string(3, '\0'));
    EXPECT_EQ(encodeDmp(picture.view(), {}).substr(4), std::string(3, '\0'));
}

TEST(EncodeImage, ChoosesTheFormatAndGivesTheSameBytesAgain) {
    const Picture picture(20, 20);
    for (const auto& [format, magic] : {std::pair{ImageFormat::png, "\x89PNG"},
                                        {ImageFormat::ppm, "P6"},
                                        {ImageFormat::pfm, "PF"},
                                        {ImageFormat::exr, "\x76\x2f\x31\x01"},
                                        {ImageFormat::dmp, "\x14"}}) {
        const std::string bytes = encodeImage(format, picture.view(), {});
        EXPECT_TRUE(bytes.starts_with(magic));
        EXPECT_EQ(bytes, encodeImage(format, picture.view(), {}));
    }
}

} // namespace
} // namespace yarte
