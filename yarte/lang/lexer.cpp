#include "yarte/lang/lexer.h"

#include "yarte/base/number.h"

#include <algorithm>
#include <string>

namespace yarte {
namespace {

bool isDigit(char c) { return c >= '0' && c <= '9'; }

/// No keyword begins like a number, so that whatever does was meant as one.
bool looksLikeNumber(std::string_view word) {
    if (word[0] == '+' || word[0] == '-') word.remove_prefix(1);
    if (word.empty()) return true;
    if (isDigit(word[0]) || word[0] == '.') return true;
    std::string lower(word.substr(0, 9));
    std::transform(lower.begin(), lower.end(), lower.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return lower == "nan" || lower == "inf" || lower == "infinity";
}

} // namespace

TokenKind kindOfWord(std::string_view word, double& value) {
    if (!looksLikeNumber(word)) return TokenKind::word;
    const ParsedNumber number = parseNumber(word);
    value = number.value;
    if (!number.error) return TokenKind::number;
    return *number.error == NumberError::outOfRange ? TokenKind::hugeNumber : TokenKind::badNumber;
}

void Lexer::skipSpaceAndComments() {
    while (at_ < text_.size()) {
        if (text_[at_] == ';')
            at_ = std::min(text_.find('\n', at_), text_.size());
        else if (isSpace(text_[at_]))
            ++at_;
        else
            return;
    }
}

std::size_t Lexer::endOfWord() const {
    std::size_t end = at_;
    while (end < text_.size() && !isSpace(text_[end]) && text_[end] != ';') ++end;
    return end;
}

std::size_t Lexer::endOfQuoted(bool& closed) const {
    for (std::size_t i = at_ + 1; i < text_.size() && text_[i] != '\n'; ++i) {
        if (text_[i] != '"') continue;
        if (i + 1 < text_.size() && text_[i + 1] == '"')
            ++i;
        else
            return closed = true, i + 1;
    }
    return closed = false, std::min(text_.find('\n', at_), text_.size());
}

void Lexer::advance() {
    skipSpaceAndComments();
    token_ = {};
    std::size_t end = at_;
    if (at_ < text_.size() && text_[at_] == '"') {
        bool closed = false;
        end = endOfQuoted(closed);
        token_.kind = closed ? TokenKind::quotedName : TokenKind::unclosedName;
    } else if (at_ < text_.size()) {
        end = endOfWord();
        token_.kind = kindOfWord(text_.substr(at_, end - at_), token_.value);
    }
    token_.text = text_.substr(at_, end - at_);
    token_.span = {id_, at_, end};
    at_ = end;
}

} // namespace yarte
