#include "yarte/base/image_file.h"

#include "yarte/base/quantise.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <string_view>

namespace yarte {

namespace {

struct FormatName {
    std::string_view extension;
    ImageFormat format;
};

constexpr std::array formatNames{
    FormatName{".png", ImageFormat::png}, FormatName{".ppm", ImageFormat::ppm},
    FormatName{".pfm", ImageFormat::pfm}, FormatName{".exr", ImageFormat::exr},
    FormatName{".dmp", ImageFormat::dmp},
};

constexpr int maxDmpSide = 65535;

char lowerCase(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

} // namespace

std::optional<ImageFormat> imageFormat(const std::filesystem::path& file) {
    std::string extension = file.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(), lowerCase);
    for (const FormatName& name : formatNames)
        if (name.extension == extension) return name.format;
    return std::nullopt;
}

std::string imageExtensions() {
    std::string text;
    for (const FormatName& name : formatNames) {
        if (!text.empty()) text += ' ';
        text += name.extension;
    }
    return text;
}

bool canHold(ImageFormat format, int width, int height) {
    return format != ImageFormat::dmp || (width <= maxDmpSide && height <= maxDmpSide);
}

std::string encodeImage(ImageFormat format, const ImageRows& image, const ImageEncoding& encoding) {
    assert(canHold(format, image.width, image.height));
    switch (format) {
    case ImageFormat::png: return encodePng(image, encoding);
    case ImageFormat::ppm: return encodePpm(image, encoding);
    case ImageFormat::pfm: return encodePfm(image);
    case ImageFormat::exr: return encodeExr(image, encoding);
    case ImageFormat::dmp: return encodeDmp(image, encoding);
    }
    return {};
}

void appendDisplayRow(std::string& bytes, const ImageRows& image, int y, const ImageEncoding& encoding) {
    const bool wide = encoding.depth == 16;
    const Quantiser quantise(wide ? 65535 : 255, encoding.displayGamma());
    const Colour* const row = image.row(y);
    for (int x = 0; x < image.width; ++x)
        for (const double v : {row[x].r, row[x].g, row[x].b}) {
            const int sample = quantise(v);
            if (wide) bytes += static_cast<char>(sample >> 8);
            bytes += static_cast<char>(sample & 255);
        }
}

} // namespace yarte
