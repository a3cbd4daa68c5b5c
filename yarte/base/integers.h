// Whole numbers in a row, as options have them: "640x480", "0,0,16,16".
#pragma once

#include <array>
#include <charconv>
#include <cstddef>
#include <optional>
#include <string_view>
#include <system_error>

namespace yarte {

/// `N` whole numbers with `separator` between them, and nothing else.
template <std::size_t N>
std::optional<std::array<int, N>> parseIntegers(std::string_view text, char separator) {
    std::array<int, N> values{};
    for (std::size_t i = 0; i < N; ++i) {
        if (i > 0) {
            if (!text.starts_with(separator)) return std::nullopt;
            text.remove_prefix(1);
        }
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), values[i]);
        if (error != std::errc{}) return std::nullopt;
        text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    }
    if (!text.empty()) return std::nullopt;
    return values;
}

} // namespace yarte
