#include "yarte/base/json.h"

#include "yarte/base/text.h"

#include <fmt/format.h>

namespace yarte {

std::string jsonString(std::string_view text) {
    std::string result = "\"";
    for (std::size_t length = 0; !text.empty(); text.remove_prefix(length)) {
        length = utf8CharacterLength(text);
        const char c = text[0];
        if (length == 0)
            result += "\\ufffd", length = 1;
        else if (c == '"' || c == '\\')
            result += {'\\', c};
        else if (c == '\n')
            result += "\\n";
        else if (static_cast<unsigned char>(c) < 0x20)
            result += fmt::format("\\u{:04x}", static_cast<int>(c));
        else
            result += text.substr(0, length);
    }
    return result + '"';
}

} // namespace yarte
