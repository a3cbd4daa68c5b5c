// Content: the bytes of buffers, each fetched when something first asks for it. A buffer that nothing asks
// for may be missing.
#pragma once

#include "convert/gltf/document.h"
#include "convert/gltf/uri.h"

namespace yarte::convert::gltf {

class Content {
public:
    /// `binary`: the .glb's, empty if there is none; must outlive this. `fileSize`: of the whole file, in
    /// bytes.
    Content(const Document&, std::string_view binary, std::size_t fileSize, UriBase, Errors&);

    /// All bytes of the view, which begin at its byteOffset; nothing after reporting why not.
    std::optional<std::string_view> bytesOf(std::uint32_t view);

    /// Asked before so many elements of an accessor are read. False after reporting that this and what came
    /// before is too much for a file of its size: a few bytes can name the same elements again and again.
    bool takeElements(std::size_t count, const Json& accessor);

    const Document& document() const { return document_; }
    const UriBase& base() const { return base_; }
    Errors& errors() { return errors_; }

private:
    struct Loaded {
        std::string own;
        std::optional<std::string_view> bytes; ///< none: it could not be read
    };
    const Loaded& load(std::uint32_t buffer);

    const Document& document_;
    std::string_view binary_;
    UriBase base_;
    Errors& errors_;
    std::map<std::uint32_t, Loaded> loaded_;
    std::size_t elements_; ///< that may still be read
};

} // namespace yarte::convert::gltf
