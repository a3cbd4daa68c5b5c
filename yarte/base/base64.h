// Base64 (RFC 4648, with padding), for data URIs.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace yarte {

std::string base64(std::string_view bytes);

/// What `text` encodes; nothing if it has other characters or an impossible length. Padding may be missing.
std::optional<std::string> base64Decoded(std::string_view text);

} // namespace yarte
