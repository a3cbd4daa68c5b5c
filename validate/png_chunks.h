// libpng takes memory for what a chunk says of its length, up to 2 GiB, before it finds that the file is
// shorter. So this is asked first.
#pragma once

#include <string_view>

namespace yarte::validate {

/// True if all chunks lie within the file, or if the bytes are not PNG's at all. Source: PNG (Third Edition),
/// 5.3, Chunk layout.
bool pngChunksFit(std::string_view bytes);

} // namespace yarte::validate
