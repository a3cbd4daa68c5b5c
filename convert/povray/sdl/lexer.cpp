#include "convert/povray/sdl/lexer.h"

#include <fmt/format.h>

#include <charconv>

namespace yarte::convert::povray::sdl {
namespace {

// Independent of the locale.
constexpr bool isDigit(char c) { return c >= '0' && c <= '9'; }
constexpr bool isLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
constexpr bool isBlank(char c) { return static_cast<unsigned char>(c) <= ' '; }

void appendUtf8(std::string& text, unsigned codePoint) {
    const auto put = [&](unsigned byte) { text += static_cast<char>(byte); };
    if (codePoint < 0x80) {
        put(codePoint);
    } else if (codePoint < 0x800) {
        put(0xc0 | codePoint >> 6), put(0x80 | (codePoint & 0x3f));
    } else {
        put(0xe0 | codePoint >> 12), put(0x80 | (codePoint >> 6 & 0x3f)), put(0x80 | (codePoint & 0x3f));
    }
}

} // namespace

void Lexer::skipBlanks() {
    while (at_ < text_.size()) {
        const char c = text_[at_];
        if (isBlank(c)) {
            ++at_;
        } else if (c == '/' && text_.substr(at_, 2) == "//") {
            at_ = std::min(text_.find('\n', at_), text_.size());
        } else if (c == '/' && text_.substr(at_, 2) == "/*") {
            const std::size_t begin = at_;
            int depth = 0; // comments nest
            do {
                const std::string_view two = text_.substr(at_, 2);
                if (two.size() < 2)
                    throw SyntaxError("sdl.unterminated-comment", "this comment has no end",
                                      span(begin, begin + 2));
                const int step = two == "/*" ? 1 : two == "*/" ? -1 : 0;
                depth += step;
                at_ += step == 0 ? 1 : 2;
            } while (depth > 0);
        } else {
            return;
        }
    }
}

Token Lexer::next() {
    skipBlanks();
    const std::size_t begin = at_;
    if (begin >= text_.size()) return {.span = span(text_.size(), text_.size())};
    const char c = text_[begin];
    if (isLetter(c)) return word(begin);
    if (isDigit(c) || (c == '.' && begin + 1 < text_.size() && isDigit(text_[begin + 1])))
        return number(begin);
    if (c == '"') return string(begin);
    if (c == '#') {
        ++at_;
        skipBlanks();
        if (at_ >= text_.size() || !isLetter(text_[at_]))
            throw SyntaxError("sdl.directive", "'#' needs a directive after it, such as #declare",
                              span(begin, begin + 1));
        Token token = word(at_);
        token.kind = TokenKind::directive;
        token.span.begin = begin;
        return token;
    }
    return punctuation(begin);
}

Token Lexer::number(std::size_t begin) {
    Token token{.kind = TokenKind::number};
    const auto [end, error] =
        std::from_chars(text_.data() + begin, text_.data() + text_.size(), token.number);
    at_ = static_cast<std::size_t>(end - text_.data());
    token.span = span(begin, at_);
    if (error == std::errc::result_out_of_range && token.number == 0) {
        // Too large or too small: strtod tells which, and the text is a plain number by now.
        token.number = std::strtod(std::string(text_.substr(begin, at_ - begin)).c_str(), nullptr);
        if (!std::isfinite(token.number))
            throw SyntaxError("sdl.number", "this number is too large", token.span);
    }
    return token;
}

Token Lexer::string(std::size_t begin) {
    ++at_;
    while (at_ < text_.size() && text_[at_] != '"') at_ += text_[at_] == '\\' ? 2 : 1;
    if (at_ >= text_.size())
        throw SyntaxError("sdl.unterminated-string", "this string has no closing quote",
                          span(begin, begin + 1));
    ++at_;
    return {.kind = TokenKind::string,
            .text = text_.substr(begin + 1, at_ - begin - 2),
            .span = span(begin, at_)};
}

Token Lexer::word(std::size_t begin) {
    at_ = begin;
    while (at_ < text_.size() && (isLetter(text_[at_]) || isDigit(text_[at_]))) ++at_;
    return {.kind = TokenKind::word, .text = text_.substr(begin, at_ - begin), .span = span(begin, at_)};
}

Token Lexer::punctuation(std::size_t begin) {
    const std::string_view two = text_.substr(begin, 2);
    Token token{.kind = TokenKind::punctuation, .mark = text_[begin]};
    if (two == "<=") token.mark = static_cast<char>(Mark::lessOrEqual);
    if (two == ">=") token.mark = static_cast<char>(Mark::greaterOrEqual);
    if (two == "!=") token.mark = static_cast<char>(Mark::notEqual);
    at_ = begin + (token.mark == text_[begin] ? 1 : 2);
    token.span = span(begin, at_);
    constexpr std::string_view known = "{}()[]<>,;:?.=+-*/!&|^@~%$";
    if (token.mark == text_[begin] && known.find(token.mark) == known.npos) {
        const auto byte = static_cast<unsigned char>(token.mark);
        throw SyntaxError("sdl.character",
                          byte < 0x7f
                              ? fmt::format("unexpected character '{}'", token.mark)
                              : fmt::format("unexpected byte 0x{:02x} outside strings and comments", byte),
                          token.span);
    }
    return token;
}

std::optional<Vec3> Lexer::literalVector() {
    const char* p = text_.data() + at_;
    const char* const end = text_.data() + text_.size();
    const auto skip = [&] {
        while (p < end && isBlank(*p)) ++p;
    };
    skip();
    if (p == end || *p++ != '<') return std::nullopt;
    double values[3];
    for (int i = 0; i < 3; ++i) {
        skip();
        if (i > 0 && p < end && *p == ',') ++p, skip();
        // A minus without a comma before it is a subtraction; "- 1" and "--1" go through the expressions.
        const bool isNegative = p < end && *p == '-';
        if (isNegative && i > 0 && p[-1] != ',' && !isBlank(p[-1])) return std::nullopt;
        if (isNegative && i > 0) {
            const char* before = p - 1;
            while (isBlank(*before)) --before;
            if (*before != ',') return std::nullopt;
        }
        if (isNegative) ++p;
        if (p == end || (!isDigit(*p) && *p != '.')) return std::nullopt;
        const auto [after, error] = std::from_chars(p, end, values[i]);
        if (error != std::errc()) return std::nullopt;
        if (isNegative) values[i] = -values[i];
        p = after;
    }
    skip();
    if (p == end || *p++ != '>') return std::nullopt;
    at_ = static_cast<std::size_t>(p - text_.data());
    return Vec3{values[0], values[1], values[2]};
}

std::string unescaped(const Token& token) {
    std::string result;
    const std::string_view text = token.text;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] != '\\' || i + 1 == text.size()) {
            result += text[i];
            continue;
        }
        switch (const char c = text[++i]) {
        case 'a': result += '\a'; break;
        case 'b': result += '\b'; break;
        case 'f': result += '\f'; break;
        case 'n': result += '\n'; break;
        case 'r': result += '\r'; break;
        case 't': result += '\t'; break;
        case 'v': result += '\v'; break;
        case '0': break; // would end the string
        case 'u': {
            unsigned value = 0;
            const char* first = text.data() + i + 1;
            const auto [after, error] =
                std::from_chars(first, first + std::min<std::size_t>(4, text.size() - i - 1), value, 16);
            if (error != std::errc() || after != first + 4)
                throw SyntaxError("sdl.escape", "\\u needs four hexadecimal digits", token.span);
            appendUtf8(result, value);
            i += 4;
            break;
        }
        default: result += c;
        }
    }
    return result;
}

} // namespace yarte::convert::povray::sdl
