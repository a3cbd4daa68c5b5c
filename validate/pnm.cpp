#include "validate/pnm.h"

#include <algorithm>
#include <charconv>
#include <fmt/format.h>

namespace yarte::validate {

namespace {

bool isSpace(char c) { return std::string_view(" \t\n\v\f\r").find(c) != std::string_view::npos; }

/// Takes the header's next number, after white space and comments.
int takeNumber(std::string_view& bytes, int largest) {
    while (!bytes.empty() && (isSpace(bytes[0]) || bytes[0] == '#'))
        bytes.remove_prefix(bytes[0] == '#' ? std::min(bytes.find('\n'), bytes.size()) : 1);
    int value = 0;
    const auto [end, error] = std::from_chars(bytes.data(), bytes.data() + bytes.size(), value);
    if (error != std::errc() || value < 1 || value > largest)
        throw PnmError(fmt::format("its header needs numbers from 1 to {}", largest));
    bytes.remove_prefix(static_cast<std::size_t>(end - bytes.data()));
    return value;
}

} // namespace

bool isBinaryPnm(std::string_view bytes) {
    return bytes.size() > 2 && (bytes.starts_with("P5") || bytes.starts_with("P6")) && isSpace(bytes[2]);
}

Picture readPnm(std::string_view bytes) {
    const bool grey = bytes[1] == '5';
    bytes.remove_prefix(2);
    const int width = takeNumber(bytes, 1'000'000), height = takeNumber(bytes, 1'000'000);
    const int largest = takeNumber(bytes, 65535);
    bytes.remove_prefix(std::min<std::size_t>(bytes.size(), 1)); // one white space ends the header

    const std::size_t sampleSize = largest > 255 ? 2 : 1, samplesPerPixel = grey ? 1 : 3;
    const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    const std::size_t needed = pixels * samplesPerPixel * sampleSize;
    if (bytes.size() < needed)
        throw PnmError(fmt::format("it ends after {} of {} bytes of pixels", bytes.size(), needed));

    const auto byte = [&](std::size_t i) {
        return static_cast<unsigned>(static_cast<unsigned char>(bytes[i]));
    };
    const auto sample = [&](std::size_t i) { // the high byte first
        const unsigned value = sampleSize == 1 ? byte(i) : byte(2 * i) << 8 | byte(2 * i + 1);
        return static_cast<double>(value) / largest;
    };
    Picture picture{width, height, {}};
    picture.pixels.reserve(pixels);
    for (std::size_t i = 0; i < pixels; ++i)
        picture.pixels.push_back(grey ? Colour{sample(i), sample(i), sample(i)}
                                      : Colour{sample(3 * i), sample(3 * i + 1), sample(3 * i + 2)});
    return picture;
}

} // namespace yarte::validate
