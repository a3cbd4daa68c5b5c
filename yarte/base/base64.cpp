#include "yarte/base/base64.h"

#include "yarte/base/huge_pages.h"

#include <array>

namespace yarte {
namespace {

constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

constexpr unsigned noDigit = 64;

constexpr auto values = [] {
    std::array<unsigned char, 256> result{};
    result.fill(noDigit);
    for (unsigned char i = 0; i < digits.size(); ++i) result[static_cast<unsigned char>(digits[i])] = i;
    return result;
}();

} // namespace

std::string base64(std::string_view bytes) {
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const auto byte = [&](std::size_t k) {
            return i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u;
        };
        const unsigned group = byte(0) << 16 | byte(1) << 8 | byte(2);
        for (const int shift : {18, 12, 6, 0}) text += digits[group >> shift & 63u];
    }
    const std::size_t padding = (3 - bytes.size() % 3) % 3;
    text.replace(text.size() - padding, padding, padding, '=');
    return text;
}

std::optional<std::string> base64Decoded(std::string_view text) {
    if (text.size() % 4 == 0)
        for (int i = 0; i < 2 && text.ends_with('='); ++i) text.remove_suffix(1);
    std::string bytes;
    reserveWhole(bytes, text.size() / 4 * 3 + 2);
    unsigned group = 0, bits = 0, foreign = 0;
    for (const char c : text) {
        const unsigned value = values[static_cast<unsigned char>(c)];
        foreign |= value & noDigit;
        group = group << 6 | value;
        bits += 6;
        if (bits < 8) continue;
        bits -= 8;
        bytes += static_cast<char>(group >> bits & 0xff);
    }
    // A digit alone is less than a byte.
    if (foreign || text.size() % 4 == 1) return std::nullopt;
    return bytes;
}

} // namespace yarte
