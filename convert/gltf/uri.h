// What a glTF file's URIs lead to: data in the URI itself, or a file in a folder that may be read.
#pragma once

#include "yarte/base/file.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace yarte::convert::gltf {

/// Where relative URIs start, and what may be read.
struct UriBase {
    std::filesystem::path folder;
    ReadableFolders readable; ///< `folder` itself included
};

/// Relative URIs of `file` (empty: standard input) start in its folder, which may be read besides `readable`.
UriBase uriBase(const std::filesystem::path& file, ReadableFolders readable);

struct Resource {
    std::string bytes;
    std::string problem; ///< why there are no bytes; empty: there are
};

/// The bytes that `uri` stands for: data:…;base64,… or a relative path, percent-encoded. Other schemes, and
/// paths that lead out of the readable folders, are refused.
Resource readUri(std::string_view uri, const UriBase&);

} // namespace yarte::convert::gltf
