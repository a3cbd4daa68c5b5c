// Lexer: the words of a scene. White space separates them, `;` starts a comment that ends with the line.
#pragma once

#include "yarte/base/source.h"

#include <string_view>

namespace yarte {

enum class TokenKind {
    word,         ///< a directive's keyword or a mesh's file name
    number,       ///< `value` is good
    badNumber,    ///< begins like a number, or is a nan or inf, but is none
    hugeNumber,   ///< a number beyond the largest double
    quotedName,   ///< "…": an extension, for file names that are no word; "" stands for a quote
    unclosedName, ///< a quote without its partner on the same line
    end,          ///< of the text
};

struct Token {
    TokenKind kind = TokenKind::end;
    std::string_view text; ///< as written, quotes included
    double value = 0;
    Span span;

    bool isArgument() const {
        return kind == TokenKind::number || kind == TokenKind::badNumber || kind == TokenKind::hugeNumber;
    }
};

/// `word` as the lexer would read it; also tells the printer which names need quotes.
TokenKind kindOfWord(std::string_view word, double& value);

/// True for the characters that separate words.
constexpr bool isSpace(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

class Lexer {
public:
    Lexer(SourceId id, const Source& source) : id_(id), text_(source.text()) { advance(); }

    const Token& current() const { return token_; }
    void advance();

private:
    void skipSpaceAndComments();
    std::size_t endOfWord() const;
    std::size_t endOfQuoted(bool& closed) const;

    SourceId id_;
    std::string_view text_;
    std::size_t at_ = 0;
    Token token_;
};

} // namespace yarte
