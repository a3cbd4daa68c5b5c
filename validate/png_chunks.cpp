#include "validate/png_chunks.h"

#include <cstddef>

namespace yarte::validate {

namespace {

constexpr std::string_view signature("\x89PNG\r\n\x1a\n", 8);

/// The four bytes, the largest first.
std::size_t lengthAt(std::string_view bytes) {
    std::size_t length = 0;
    for (const char byte : bytes.substr(0, 4)) length = length << 8 | static_cast<unsigned char>(byte);
    return length;
}

} // namespace

bool pngChunksFit(std::string_view bytes) {
    constexpr std::size_t frame = 4 + 4 + 4; // length, type and checksum
    if (!bytes.starts_with(signature)) return true;
    bytes.remove_prefix(signature.size());
    while (bytes.size() >= frame) {
        const std::size_t length = lengthAt(bytes);
        if (length > bytes.size() - frame) return false;
        if (bytes.substr(4, 4) == "IEND") return true; // what follows is nobody's
        bytes.remove_prefix(frame + length);
    }
    return bytes.empty();
}

} // namespace yarte::validate
