#include "yarte/base/image_file.h"
#include "yarte/base/quantise.h"

#include <array>
#include <cmath>

namespace yarte {

namespace {

/// The paper's consGammaTable: from a linear byte to a displayed one, both truncated.
std::array<char, 256> gammaTable(double gamma) {
    std::array<char, 256> table{};
    for (int c = 0; c < 256; ++c) {
        // The paper leaves the table out at gamma 1, where 255 * (c / 255) may round below c.
        const double displayed = gamma == 1 ? c : 255 * std::pow(c / 255.0, 1 / gamma);
        table[static_cast<std::size_t>(c)] = static_cast<char>(static_cast<int>(displayed));
    }
    return table;
}

void appendShort(std::string& bytes, int value, bool bigEndian) {
    const char high = static_cast<char>(value >> 8), low = static_cast<char>(value & 255);
    bytes += bigEndian ? high : low;
    bytes += bigEndian ? low : high;
}

} // namespace

std::string encodeDmp(const ImageRows& image, const ImageEncoding& encoding) {
    const std::array<char, 256> table = gammaTable(encoding.gamma);
    std::string bytes;
    appendShort(bytes, image.width, encoding.bigEndian);
    appendShort(bytes, image.height, encoding.bigEndian);
    for (int y = 0; y < image.height; ++y) {
        const Colour* const row = image.row(y);
        for (int x = 0; x < image.width; ++x)
            for (const double v : {row[x].r, row[x].g, row[x].b})
                bytes += table[static_cast<std::size_t>(clampToUnit(v) * 255)];
    }
    return bytes;
}

} // namespace yarte
