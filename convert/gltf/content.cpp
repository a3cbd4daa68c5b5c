#include "convert/gltf/content.h"

#include <fmt/format.h>

namespace yarte::convert::gltf {
namespace {

/// Elements of accessors: what any file may read, and what it may read for each byte of it and its buffers.
constexpr std::size_t anyElements = std::size_t{1} << 22, elementsPerByte = 256;

} // namespace

Content::Content(const Document& document, std::string_view binary, std::size_t fileSize, UriBase base,
                 Errors& errors)
    : document_(document), binary_(binary), base_(std::move(base)), errors_(errors),
      elements_(anyElements + elementsPerByte * fileSize) {}

const Content::Loaded& Content::load(std::uint32_t id) {
    const auto [entry, isNew] = loaded_.try_emplace(id);
    Loaded& loaded = entry->second;
    if (!isNew) return loaded;
    const Buffer& buffer = document_.buffers[id];
    const auto fail = [&](std::string message) {
        errors_.report("gltf.bad-buffer", std::move(message), *buffer.json);
    };
    std::string_view bytes;
    if (buffer.uri) {
        Resource resource = readUri(*buffer.uri, base_);
        if (!resource.problem.empty()) return fail(std::move(resource.problem)), loaded;
        loaded.own = std::move(resource.bytes);
        bytes = loaded.own;
        elements_ += elementsPerByte * bytes.size();
    } else if (id == 0) {
        bytes = binary_;
    }
    if (bytes.size() < buffer.length)
        return fail(fmt::format("byteLength is {}, but there are {} bytes", buffer.length, bytes.size())),
               loaded;
    loaded.bytes = bytes.substr(0, buffer.length);
    return loaded;
}

std::optional<std::string_view> Content::bytesOf(std::uint32_t id) {
    const BufferView& view = document_.views[id];
    const Buffer& buffer = document_.buffers[view.buffer];
    // A compressed view may come with an uncompressed form to fall back to; a buffer without bytes is none.
    if (view.compressed && !buffer.uri && (view.buffer != 0 || binary_.size() < buffer.length)) {
        errors_.report(
            "gltf.extension-required",
            fmt::format("the content is compressed by {}, which is not supported", view.compressed),
            *view.json);
        return std::nullopt;
    }
    const Loaded& loaded = load(view.buffer);
    if (!loaded.bytes) return std::nullopt;
    return loaded.bytes->substr(view.offset, view.length);
}

bool Content::takeElements(std::size_t count, const Json& accessor) {
    if (count > elements_) {
        errors_.report("gltf.too-large", "the elements that are read are too many for a file of this size",
                       accessor);
        return false;
    }
    elements_ -= count;
    return true;
}

} // namespace yarte::convert::gltf
