// Base64 (RFC 4648, with padding), for data URIs.
#pragma once

#include <string>
#include <string_view>

namespace yarte {

std::string base64(std::string_view bytes);

} // namespace yarte
