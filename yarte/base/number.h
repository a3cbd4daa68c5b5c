// Numbers as text, independent of the locale.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace yarte {

enum class NumberError { notANumber, outOfRange };

struct ParsedNumber {
    double value = 0;
    std::optional<NumberError> error;
};

/// Reads the whole of `text` as a decimal floating-point number ("+1.5e-3", "200."), correctly rounded.
/// "nan", "inf" and hexadecimal are not numbers; a magnitude beyond the largest double is out of range;
/// one below the smallest is the nearest double (a denormal or 0).
ParsedNumber parseNumber(std::string_view text);

/// The shortest decimal text that reads back as exactly `value`, which must be finite.
std::string printNumber(double value);

} // namespace yarte
