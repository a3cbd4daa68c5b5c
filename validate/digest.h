// Digest: SHA-1 of bytes, to recognise the same input and to notice damaged files; not against forgers.
#pragma once

#include <string>
#include <string_view>

namespace yarte::validate {

/// 40 hexadecimal digits.
std::string digest(std::string_view bytes);

} // namespace yarte::validate
