// The little that is needed to write JSON.
#pragma once

#include <string>
#include <string_view>

namespace yarte {

/// `text` as a JSON string, quotes included; invalid UTF-8 becomes U+FFFD.
std::string jsonString(std::string_view text);

} // namespace yarte
