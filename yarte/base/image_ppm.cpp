#include "yarte/base/image_file.h"

#include <fmt/format.h>

namespace yarte {

std::string encodePpm(const ImageRows& image, const ImageEncoding& encoding) {
    const int maximum = encoding.depth == 16 ? 65535 : 255;
    std::string bytes = fmt::format("P6\n{} {}\n{}\n", image.width, image.height, maximum);
    for (int y = 0; y < image.height; ++y) appendDisplayRow(bytes, image, y, encoding);
    return bytes;
}

} // namespace yarte
