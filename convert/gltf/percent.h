// Bytes as text that URIs and JSON take (RFC 3986 section 2.1).
#pragma once

#include <string>
#include <string_view>

namespace yarte::convert::gltf {

/// Letters, digits and -._~/ stay.
std::string percentEncoded(std::string_view bytes);
/// "%20" is a space; a "%" without two digits behind it stands for itself.
std::string percentDecoded(std::string_view text);

} // namespace yarte::convert::gltf
