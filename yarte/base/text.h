// Text of unknown origin, made fit for messages; and what a misspelt word was meant to be.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace yarte {

/// The length in bytes (1 to 4) of the UTF-8 character at the beginning of `text`; 0 if there is no valid
/// one.
std::size_t utf8CharacterLength(std::string_view text);

/// `text` with every control character and invalid byte replaced by U+FFFD: safe on any terminal.
std::string printable(std::string_view text);

/// A piece of an input for a message: printable, in quotes, shortened after 40 characters.
std::string inQuotes(std::string_view text);

/// The one of `words` that is nearest to `word` (case apart), if it is near enough to be meant: at most one
/// in three characters inserted, deleted, replaced or swapped with its neighbour.
std::optional<std::string_view> closestWord(std::string_view word, std::span<const std::string_view> words);

} // namespace yarte
