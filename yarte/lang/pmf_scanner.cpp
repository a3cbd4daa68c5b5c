#include "yarte/lang/pmf_scanner.h"

#include "yarte/base/number.h"
#include "yarte/lang/lexer.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace yarte {
namespace {

bool endsWord(char c) { return isSpace(c) || c == ';'; }

} // namespace

bool PmfScanner::atLetter() const {
    return at_ != end_ && ((*at_ >= 'a' && *at_ <= 'z') || (*at_ >= 'A' && *at_ <= 'Z'));
}

void PmfScanner::skipSpace() {
    while (at_ != end_) {
        if (*at_ == ';')
            at_ = std::find(at_, end_, '\n');
        else if (isSpace(*at_))
            ++at_;
        else
            return;
    }
}

std::string_view PmfScanner::wordHere() {
    const char* const begin = at_;
    at_ = std::find_if(at_, end_, endsWord);
    return {begin, static_cast<std::size_t>(at_ - begin)};
}

std::string_view PmfScanner::nextWord() {
    skipSpace();
    return wordHere();
}

bool PmfScanner::moreOnLine() {
    while (at_ != end_ && *at_ != '\n' && isSpace(*at_)) ++at_;
    return at_ != end_ && !endsWord(*at_);
}

std::string_view PmfScanner::nextWordOnLine() {
    moreOnLine();
    return wordHere();
}

bool PmfScanner::nextIndex(std::size_t limit, std::uint32_t& index) {
    skipSpace();
    const auto [end, error] = std::from_chars(at_, end_, index);
    if (error != std::errc{} || index >= limit || (end != end_ && !endsWord(*end))) return false;
    at_ = end;
    return true;
}

bool PmfScanner::nextNumber(double& value) {
    skipSpace();
    // What from_chars takes in one go is nearly every number; the rest ("+1", "1e-400") is the careful way's.
    const auto [end, error] = std::from_chars(at_, end_, value);
    if (error == std::errc{} && std::isfinite(value) && (end == end_ || endsWord(*end))) {
        at_ = end;
        return true;
    }
    const char* const begin = at_;
    const ParsedNumber number = parseNumber(wordHere());
    value = number.value;
    if (number.error) at_ = begin;
    return !number.error;
}

bool PmfScanner::skipWord(std::string_view word) {
    skipSpace();
    const char* const begin = at_;
    if (wordHere() == word) return true;
    at_ = begin;
    return false;
}

std::size_t PmfScanner::endOfLine(std::size_t offset) const {
    const char* const begin = begin_ + offset;
    const char* end = std::find_if(begin, end_, [](char c) { return c == '\n' || c == ';'; });
    while (end != begin && isSpace(end[-1])) --end;
    return static_cast<std::size_t>(end - begin_);
}

std::size_t PmfScanner::endOfText() const {
    const char* end = end_;
    while (end != begin_ && isSpace(end[-1])) --end;
    return static_cast<std::size_t>(end - begin_);
}

bool PmfScanner::toIndex(std::string_view word, std::uint32_t& index) {
    const char* const end = word.data() + word.size();
    const auto result = std::from_chars(word.data(), end, index);
    return result.ec == std::errc{} && result.ptr == end;
}

} // namespace yarte
