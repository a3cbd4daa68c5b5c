#include "convert/gltf/image.h"

#include "yarte/base/deflate.h"
#include "yarte/base/srgb.h"

#include <fmt/format.h>

// tinygltf brings the decoder (stb_image).
#include <tiny_gltf.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

namespace yarte::convert::gltf {
namespace {

struct Size {
    std::size_t width = 0, height = 0;
};

std::size_t bigEndian(std::string_view bytes, std::size_t at, std::size_t count) {
    std::size_t value = 0;
    for (std::size_t i = at; i < at + count; ++i) value = value << 8 | static_cast<unsigned char>(bytes[i]);
    return value;
}

/// In its first chunk, IHDR.
std::optional<Size> pngSize(std::string_view bytes) {
    using namespace std::string_view_literals;
    if (!bytes.starts_with("\x89PNG\r\n\x1a\n"sv) || bytes.size() < 24) return std::nullopt;
    return Size{bigEndian(bytes, 16, 4), bigEndian(bytes, 20, 4)};
}

/// In the start-of-frame segment, one of C0 to CF without C4, C8 and CC, which are something else.
std::optional<Size> jpegSize(std::string_view bytes) {
    if (!bytes.starts_with("\xff\xd8")) return std::nullopt;
    for (std::size_t at = 2; at + 9 <= bytes.size();) {
        if (bigEndian(bytes, at, 1) != 0xff) return std::nullopt;
        const std::size_t marker = bigEndian(bytes, at + 1, 1);
        if (marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc)
            return Size{bigEndian(bytes, at + 7, 2), bigEndian(bytes, at + 5, 2)};
        at += marker == 0xff ? 1 : 2 + bigEndian(bytes, at + 2, 2);
    }
    return std::nullopt;
}

/// Of RGBA pixels: how often each value occurs in each channel says it all.
template <class Value>
ImageAverage average(const Value* values, std::size_t pixels) {
    constexpr std::size_t kinds = std::size_t{1} << (8 * sizeof(Value));
    std::vector<std::array<std::uint32_t, 4>> counts(kinds);
    for (std::size_t i = 0; i < pixels; ++i)
        for (std::size_t c = 0; c < 4; ++c) ++counts[values[4 * i + c]][c];
    std::array<double, 4> raw{}, linear{};
    for (std::size_t v = 0; v < kinds; ++v) {
        const double value = static_cast<double>(v) / (kinds - 1), light = linearFromSrgb(value);
        for (std::size_t c = 0; c < 4; ++c) {
            const double part = static_cast<double>(counts[v][c]) / static_cast<double>(pixels);
            raw[c] += part * value, linear[c] += part * light;
        }
    }
    return {{linear[0], linear[1], linear[2]}, {raw[0], raw[1], raw[2]}, raw[3], {}};
}

/// Pixels of one bit in deflate: no image has more, and none needs room for what it only says that it has.
constexpr std::size_t pixelsPerByte = 8 * mostFromDeflatedByte;

ImageAverage fail(std::string problem) { return {{1, 1, 1}, {1, 1, 1}, 1, std::move(problem)}; }

} // namespace

ImageAverage averageOf(std::string_view bytes) {
    const auto png = pngSize(bytes);
    const auto size = png ? png : jpegSize(bytes);
    if (!size) return fail("it is neither PNG nor JPEG");
    const std::size_t most = std::min(maxImagePixels, pixelsPerByte * bytes.size());
    if (size->width * size->height > most || bytes.size() > std::numeric_limits<int>::max())
        return fail(fmt::format("{}x{} pixels are too many", size->width, size->height));
    tinygltf::Image image;
    std::string error, warning;
    // The user pointer asks for four channels.
    if (!tinygltf::LoadImageData(&image, 0, &error, &warning, 0, 0,
                                 reinterpret_cast<const unsigned char*>(bytes.data()),
                                 static_cast<int>(bytes.size()), nullptr))
        return fail("it cannot be decoded");
    const std::size_t pixels = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    if (image.bits == 8) return average(image.image.data(), pixels);
    // 16 bits to a value, in this machine's order.
    return average(reinterpret_cast<const std::uint16_t*>(image.image.data()), pixels);
}

} // namespace yarte::convert::gltf
