// Deflate, the compression of PNG, OpenEXR and TIFF: how much a few bytes of it can stand for.
#pragma once

#include <cstddef>

namespace yarte {

/// Bytes that one byte stands for, at most: 258 for two codes of a bit each [RFC 1951; "zlib Technical
/// Details"].
inline constexpr std::size_t mostFromDeflatedByte = 1032;

} // namespace yarte
