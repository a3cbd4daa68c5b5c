#include "yarte/base/image_file.h"

#include <fmt/format.h>

#include <bit>
#include <cstdint>

namespace yarte {

namespace {

void appendFloat(std::string& bytes, double value) {
    const auto bits = std::bit_cast<std::uint32_t>(static_cast<float>(value));
    for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(bits >> shift & 255);
}

} // namespace

std::string encodePfm(const ImageRows& image) {
    // A negative scale says little-endian.
    std::string bytes = fmt::format("PF\n{} {}\n-1.0\n", image.width, image.height);
    for (int y = image.height - 1; y >= 0; --y) {
        const Colour* const row = image.row(y);
        for (int x = 0; x < image.width; ++x)
            for (const double v : {row[x].r, row[x].g, row[x].b}) appendFloat(bytes, v);
    }
    return bytes;
}

} // namespace yarte
