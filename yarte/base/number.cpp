#include "yarte/base/number.h"

#include <charconv>
#include <limits>

namespace yarte {
namespace {

bool isDigit(char c) { return c >= '0' && c <= '9'; }

/// std::from_chars reports "too large" and "too small" alike; the sign of the decimal exponent tells them
/// apart.
bool isBelowOne(std::string_view text) {
    long exponentOfFirstDigit = 0; // of the first non-zero digit, before the written exponent
    bool seenPoint = false, seenDigit = false;
    std::size_t i = 0;
    for (; i < text.size() && (isDigit(text[i]) || text[i] == '.'); ++i) {
        if (text[i] == '.')
            seenPoint = true;
        else if (seenDigit)
            exponentOfFirstDigit += seenPoint ? 0 : 1;
        else if (text[i] != '0')
            seenDigit = true, exponentOfFirstDigit -= seenPoint ? 1 : 0;
        else
            exponentOfFirstDigit -= seenPoint ? 1 : 0;
    }
    if (!seenDigit) return true;
    if (i < text.size()) { // the exponent; one beyond any text's length decides by its sign alone
        const bool negative = i + 1 < text.size() && text[i + 1] == '-';
        std::string_view digits = text.substr(i + 1);
        if (!digits.empty() && (digits[0] == '+' || digits[0] == '-')) digits.remove_prefix(1);
        long exponent = 0;
        const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), exponent);
        if (error != std::errc{} || exponent > std::numeric_limits<long>::max() / 2) return negative;
        exponentOfFirstDigit += negative ? -exponent : exponent;
    }
    return exponentOfFirstDigit < 0;
}

} // namespace

ParsedNumber parseNumber(std::string_view text) {
    std::string_view magnitude = text;
    const bool negative = !text.empty() && text[0] == '-';
    if (!text.empty() && (text[0] == '+' || text[0] == '-')) magnitude.remove_prefix(1);
    // from_chars would take "inf" and "nan".
    const bool startsAsNumber =
        !magnitude.empty() &&
        (isDigit(magnitude[0]) || (magnitude[0] == '.' && magnitude.size() > 1 && isDigit(magnitude[1])));
    if (!startsAsNumber) return {0, NumberError::notANumber};
    ParsedNumber result;
    const auto [end, error] =
        std::from_chars(magnitude.data(), magnitude.data() + magnitude.size(), result.value);
    if (end != magnitude.data() + magnitude.size()) return {0, NumberError::notANumber};
    if (error == std::errc::result_out_of_range) {
        if (!isBelowOne(magnitude)) return {0, NumberError::outOfRange};
        result.value = 0;
    }
    if (negative) result.value = -result.value;
    return result;
}

std::string printNumber(double value) {
    char buffer[32];
    const auto [end, error] = std::to_chars(buffer, buffer + sizeof buffer, value);
    return {buffer, end};
}

} // namespace yarte
