#include "validate/samples.h"

#include <gtest/gtest.h>
#include <random>
#include <zlib.h>

namespace yarte::validate {
namespace {

std::vector<unsigned char> inflated(const std::string& packed, std::size_t size) {
    std::vector<unsigned char> bytes(size);
    uLongf length = size;
    EXPECT_EQ(uncompress(bytes.data(), &length, reinterpret_cast<const Bytef*>(packed.data()), packed.size()),
              Z_OK);
    EXPECT_EQ(length, size);
    return bytes;
}

/// The inverse of pack, written as report/samples.js has it.
std::vector<std::int32_t> unpacked(const std::string& packed, int width, int height, int channels) {
    const int row = width * channels, count = row * height;
    const auto planes = inflated(packed, static_cast<std::size_t>(3 * count));
    std::vector<std::int32_t> values;
    const auto at = [&](int i) { return values[static_cast<std::size_t>(i)]; };
    for (int i = 0; i < count; ++i) {
        int code = 0;
        for (int plane = 2; plane >= 0; --plane)
            code = code << 8 | planes[static_cast<std::size_t>(plane * count + i)];
        const bool left = i % row >= channels, above = i >= row;
        const int predicted = (left ? at(i - channels) : 0) + (above ? at(i - row) : 0) -
                              (left && above ? at(i - row - channels) : 0);
        values.push_back(predicted + (code & 1 ? -((code + 1) >> 1) : code >> 1));
    }
    return values;
}

TEST(Samples, ComeBackAsTheyWere) {
    constexpr unsigned seed = 20240501;
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    for (const auto& [width, height, channels] :
         {std::array{1, 1, 1}, {1, 9, 3}, {9, 1, 3}, {17, 13, 3}, {8, 8, 1}}) {
        Samples samples{width, height, channels, {}};
        std::uniform_int_distribution<std::int32_t> any(-(1 << 20), (1 << 20) - 1);
        for (int i = 0; i < width * height * channels; ++i) samples.values.push_back(any(random));
        EXPECT_EQ(unpacked(pack(samples), width, height, channels), samples.values);
    }
}

TEST(Samples, EvenLightCostsNearlyNothing) {
    Samples samples{256, 256, 3, {}};
    for (int y = 0; y < 256; ++y)
        for (int x = 0; x < 256; ++x)
            for (int c = 0; c < 3; ++c) samples.values.push_back(100 * x + 50 * y + 1000 * c);
    EXPECT_LT(pack(samples).size(), 3000u) << "of 393216 bytes with 16 bits a sample";
}

} // namespace
} // namespace yarte::validate
