#include "validate/samples.h"

#include <stdexcept>
#include <zlib.h>

namespace yarte::validate {

namespace {

std::int32_t predicted(const Samples& samples, int x, int y, int channel) {
    const auto at = [&](int column, int row) {
        return column < 0 || row < 0 ? 0 : samples.values[samples.index(column, row, channel)];
    };
    return at(x - 1, y) + at(x, y - 1) - at(x - 1, y - 1);
}

constexpr std::uint32_t withoutSign(std::int32_t residual) {
    return residual >= 0 ? 2 * static_cast<std::uint32_t>(residual)
                         : 2 * static_cast<std::uint32_t>(-residual) - 1;
}

std::string compressed(const std::string& bytes) {
    uLongf size = compressBound(bytes.size());
    std::string result(size, '\0');
    if (compress2(reinterpret_cast<Bytef*>(result.data()), &size,
                  reinterpret_cast<const Bytef*>(bytes.data()), bytes.size(), Z_DEFAULT_COMPRESSION) != Z_OK)
        throw std::runtime_error("zlib cannot compress");
    result.resize(size);
    return result;
}

} // namespace

std::size_t Samples::index(int x, int y, int channel) const {
    return static_cast<std::size_t>((static_cast<std::int64_t>(y) * width + x) * channels + channel);
}

std::string pack(const Samples& samples) {
    const std::size_t count = samples.values.size();
    std::string planes(3 * count, '\0');
    for (int y = 0; y < samples.height; ++y)
        for (int x = 0; x < samples.width; ++x)
            for (int channel = 0; channel < samples.channels; ++channel) {
                const std::size_t i = samples.index(x, y, channel);
                const std::uint32_t code = withoutSign(samples.values[i] - predicted(samples, x, y, channel));
                for (std::size_t plane = 0; plane < 3; ++plane)
                    planes[plane * count + i] = static_cast<char>(code >> 8 * plane & 0xFF);
            }
    return compressed(planes);
}

} // namespace yarte::validate
