// Numbers in a line of text, separated by commas.
#pragma once

#include "yarte/base/number.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

namespace yarte::validate {

/// Just N of them, else nothing.
template <std::size_t N>
std::optional<std::array<double, N>> numbersIn(std::string_view line) {
    std::array<double, N> numbers{};
    for (std::size_t i = 0; i < N; ++i) {
        const std::size_t end = i + 1 < N ? line.find(',') : line.size();
        if (end == std::string_view::npos) return std::nullopt;
        const ParsedNumber number = parseNumber(line.substr(0, end));
        if (number.error) return std::nullopt;
        numbers[i] = number.value;
        line.remove_prefix(i + 1 < N ? end + 1 : end);
    }
    return numbers;
}

} // namespace yarte::validate
