#include "convert/gltf/container.h"

#include <fmt/format.h>

#include <cstdint>
#include <utility>

namespace yarte::convert::gltf {
namespace {

constexpr std::size_t headerSize = 12, chunkHeaderSize = 8;
constexpr std::uint32_t jsonChunk = 0x4E4F534A, binaryChunk = 0x004E4942;

/// Little-endian.
std::uint32_t wordAt(std::string_view bytes, std::size_t offset) {
    std::uint32_t word = 0;
    for (std::size_t i = 4; i-- > 0;) word = word << 8 | static_cast<unsigned char>(bytes[offset + i]);
    return word;
}

class GlbReader {
public:
    GlbReader(std::string_view bytes, const std::string& file, Diagnostics& diagnostics)
        : bytes_(bytes), file_(file), diagnostics_(diagnostics) {}

    std::optional<Container> read() {
        if (bytes_.size() < headerSize) return fail("the file ends in its header");
        if (const auto version = wordAt(bytes_, 4); version != 2)
            return fail(fmt::format("the container's version must be 2, got {}", version));
        const std::size_t length = wordAt(bytes_, 8);
        if (length > bytes_.size())
            return fail(fmt::format("the file is {} bytes long, but says {}", bytes_.size(), length));
        bytes_ = bytes_.substr(0, length);
        std::size_t at = headerSize;
        Container result;
        for (bool isFirst = true; at < bytes_.size() || isFirst; isFirst = false) {
            if (bytes_.size() < at + chunkHeaderSize)
                return fail(fmt::format("the file ends in the chunk header at byte {}", at));
            const std::size_t size = wordAt(bytes_, at);
            const std::uint32_t type = wordAt(bytes_, at + 4);
            if (size > bytes_.size() - at - chunkHeaderSize)
                return fail(fmt::format("the chunk at byte {} is longer than the file", at));
            const std::string_view chunk = bytes_.substr(at + chunkHeaderSize, size);
            if (isFirst != (type == jsonChunk))
                return fail("the first chunk, and no other, must be the JSON");
            if (type == jsonChunk) result.json = chunk;
            if (type == binaryChunk && result.binary) return fail("there are two binary chunks");
            if (type == binaryChunk) result.binary = chunk;
            at += chunkHeaderSize + size;
        }
        return result;
    }

private:
    std::nullopt_t fail(std::string message) {
        diagnostics_.error("gltf.bad-container", std::move(message)).file = file_;
        return std::nullopt;
    }

    std::string_view bytes_;
    const std::string& file_;
    Diagnostics& diagnostics_;
};

} // namespace

std::optional<Container> openContainer(std::string_view bytes, const std::string& file,
                                       Diagnostics& diagnostics) {
    if (!bytes.starts_with("glTF")) return Container{bytes, {}};
    return GlbReader(bytes, file, diagnostics).read();
}

} // namespace yarte::convert::gltf
