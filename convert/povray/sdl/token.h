// Tokens of POV-Ray's scene description language.
#pragma once

#include "yarte/base/source.h"

#include <cstdint>
#include <memory>
#include <string_view>

namespace yarte::convert::povray::sdl {

struct Symbol;

enum class TokenKind : std::uint8_t {
    end,         ///< of the text
    number,      ///< unsigned: a sign is an operator
    string,      ///< `text` is between the quotes, escapes as written
    word,        ///< identifiers and keywords: which of them is for the parser to know
    directive,   ///< `text` is the word after the '#'
    punctuation, ///< `mark`
};

/// Of two characters: '<=', '>=', '!='.
enum class Mark : char { lessOrEqual = 'l', greaterOrEqual = 'g', notEqual = 'n' };

struct Token {
    TokenKind kind = TokenKind::end;
    char mark = 0; ///< punctuation: the character, or one of `Mark`
    double number = 0;
    std::string_view text{};
    Span span{};
    /// What a word named when it was read: the end of a macro may come, and take its names, before it is
    /// used.
    std::shared_ptr<Symbol> symbol{};

    bool is(char m) const { return kind == TokenKind::punctuation && mark == m; }
    bool is(Mark m) const { return is(static_cast<char>(m)); }
    bool isWord(std::string_view w) const { return kind == TokenKind::word && text == w; }
};

} // namespace yarte::convert::povray::sdl
