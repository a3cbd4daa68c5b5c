#include "validate/exr_header.h"

#include <bit>
#include <cstdint>
#include <cstring>
#include <optional>
#include <utility>

namespace yarte::validate {

namespace {

constexpr std::string_view magic("\x76\x2f\x31\x01", 4);

static_assert(std::endian::native == std::endian::little, "numbers are taken as they lie in the file");

/// Types of one size, in bytes. OpenEXR reads a value by its type, whatever size stands before it.
constexpr std::pair<std::string_view, std::size_t> fixedSizes[] = {{"box2f", 16},
                                                                   {"box2i", 16},
                                                                   {"chromaticities", 32},
                                                                   {"compression", 1},
                                                                   {"deepImageState", 1},
                                                                   {"double", 8},
                                                                   {"envmap", 1},
                                                                   {"float", 4},
                                                                   {"int", 4},
                                                                   {"keycode", 28},
                                                                   {"lineOrder", 1},
                                                                   {"m33d", 72},
                                                                   {"m33f", 36},
                                                                   {"m44d", 128},
                                                                   {"m44f", 64},
                                                                   {"rational", 8},
                                                                   {"tiledesc", 9},
                                                                   {"timecode", 8},
                                                                   {"v2d", 16},
                                                                   {"v2f", 8},
                                                                   {"v2i", 8},
                                                                   {"v3d", 24},
                                                                   {"v3f", 12},
                                                                   {"v3i", 12}};

/// The next bytes as a number of the type T.
template <class T>
std::optional<T> takeNumber(std::string_view& rest) {
    T number;
    if (rest.size() < sizeof number) return std::nullopt;
    std::memcpy(&number, rest.data(), sizeof number);
    rest.remove_prefix(sizeof number);
    return number;
}

/// As many bytes as the number that stands before them says.
std::optional<std::string_view> takeSized(std::string_view& rest) {
    const auto size = takeNumber<std::int32_t>(rest);
    if (!size || *size < 0 || static_cast<std::size_t>(*size) > rest.size()) return std::nullopt;
    const std::string_view taken = rest.substr(0, static_cast<std::size_t>(*size));
    rest.remove_prefix(taken.size());
    return taken;
}

/// What stands before the next zero byte.
std::optional<std::string_view> takeName(std::string_view& rest) {
    const std::size_t end = rest.find('\0');
    if (end == rest.npos) return std::nullopt;
    const std::string_view name = rest.substr(0, end);
    rest.remove_prefix(end + 1);
    return name;
}

/// A name and 16 bytes for each channel, and an empty name.
bool isChannelList(std::string_view value) {
    constexpr std::size_t channelSize = 16;
    while (const auto name = takeName(value)) {
        if (name->empty()) return value.empty();
        if (value.size() < channelSize) break;
        value.remove_prefix(channelSize);
    }
    return false;
}

bool isStringVector(std::string_view value) {
    while (!value.empty())
        if (!takeSized(value)) return false;
    return true;
}

/// Width and height, and four bytes a pixel.
bool isPreview(std::string_view value) {
    const auto width = takeNumber<std::uint32_t>(value), height = takeNumber<std::uint32_t>(value);
    return width && height && (*width == 0 || value.size() / 4 / *width == *height);
}

/// True if OpenEXR, which reads by the type, reads as many bytes as there are.
bool isOfType(std::string_view type, std::string_view value) {
    for (const auto& [name, size] : fixedSizes)
        if (type == name) return value.size() == size;
    if (type == "chlist") return isChannelList(value);
    if (type == "stringvector") return isStringVector(value);
    if (type == "preview") return isPreview(value);
    return true; // text and what it does not know: by the size
}

/// Name, type, size and value.
bool takeAttribute(std::string_view& rest) {
    if (!takeName(rest)) return false;
    const auto type = takeName(rest);
    const auto value = type ? takeSized(rest) : std::nullopt;
    return value && isOfType(*type, *value);
}

} // namespace

bool exrAttributesFit(std::string_view bytes) {
    if (!bytes.starts_with(magic)) return true;
    std::string_view rest = bytes.substr(magic.size());
    const auto version = takeNumber<std::uint32_t>(rest);
    if (!version) return false;
    const bool hasManyParts = *version & 0x1000;
    do {
        while (!rest.empty() && rest.front() != '\0')
            if (!takeAttribute(rest)) return false;
        if (rest.empty()) return false;
        rest.remove_prefix(1); // ends a header; of many, an empty one ends the list
    } while (hasManyParts && !rest.starts_with('\0'));
    return true;
}

} // namespace yarte::validate
