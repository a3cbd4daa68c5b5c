// Lexer: the text of an SDL file as tokens, one at a time, from any place: a loop reads its body again.
#pragma once

#include "convert/povray/sdl/token.h"
#include "yarte/base/vec3.h"

#include <optional>
#include <stdexcept>
#include <string>

namespace yarte::convert::povray::sdl {

/// An error in the text; it ends the reading, as in POV-Ray. `code` is a literal.
struct SyntaxError : std::runtime_error {
    SyntaxError(std::string_view errorCode, const std::string& message, Span place)
        : std::runtime_error(message), code(errorCode), span(place) {}
    std::string_view code;
    Span span;
};

class Lexer {
public:
    Lexer(std::string_view text, SourceId source, std::size_t offset = 0)
        : text_(text), source_(source), at_(offset) {}

    /// Throws SyntaxError on an unterminated string or comment, or a character that SDL does not know.
    Token next();

    std::size_t offset() const { return at_; }
    void seek(std::size_t offset) { at_ = offset; }
    SourceId source() const { return source_; }

    /// If "<number, number, number>" comes next, that, and moves past it; else nothing, and stays. Commas are
    /// optional. This is most of a mesh's text, and read ten times faster than through tokens.
    std::optional<Vec3> literalVector();
    /// Without reading it: whether `mark` comes next.
    bool isAt(char mark) {
        skipBlanks();
        return at_ < text_.size() && text_[at_] == mark;
    }
    /// Moves past `mark` if it comes next.
    bool skip(char mark) {
        const bool is = isAt(mark);
        at_ += is ? 1 : 0;
        return is;
    }

private:
    void skipBlanks();
    Token number(std::size_t begin);
    Token string(std::size_t begin);
    Token word(std::size_t begin);
    Token punctuation(std::size_t begin);
    Span span(std::size_t begin, std::size_t end) const { return {source_, begin, end}; }

    std::string_view text_;
    SourceId source_;
    std::size_t at_;
};

/// The text of a string token: \n, \t, \", \\, \uXXXX, ... replaced.
std::string unescaped(const Token&);

} // namespace yarte::convert::povray::sdl
