#include "yarte/base/excerpt.h"

#include "yarte/base/text.h"

#include <algorithm>

namespace yarte {
namespace {

constexpr std::size_t tabWidth = 4;
// A line longer than this many bytes is cut to so many around the place.
constexpr std::size_t maxBytes = 110, bytesBefore = 40, bytesAfter = 60;

bool isContinuation(char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }

/// The nearest beginning of a character at or before `at`; invalid UTF-8 is not searched for long.
std::size_t characterStart(std::string_view line, std::size_t at) {
    for (int step = 0; step < 3 && at > 0 && at < line.size() && isContinuation(line[at]); ++step) --at;
    return at;
}

} // namespace

Excerpt excerpt(const Source& source, Span span) {
    const LineColumn place = source.position(span.begin);
    const std::string_view line = source.line(place.line);
    const std::size_t begin = std::min(place.column - 1, line.size());
    const std::size_t end = std::clamp(begin + (span.end - span.begin), begin, line.size());

    std::size_t from = 0, to = line.size();
    if (line.size() > maxBytes) {
        from = begin > bytesBefore ? characterStart(line, begin - bytesBefore) : 0;
        to = characterStart(line, std::min(begin + bytesAfter, line.size()));
    }
    Excerpt result;
    if (from > 0) result = {"...", "   "};
    std::size_t column = result.text.size();
    for (std::size_t at = from, length = 0; at < to; at += length) {
        length = std::max<std::size_t>(utf8CharacterLength(line.substr(at, 4)), 1);
        const bool isTab = line[at] == '\t';
        const std::size_t width = isTab ? tabWidth - column % tabWidth : 1;
        column += width;
        result.text += isTab ? std::string(width, ' ') : printable(line.substr(at, length));
        if (at + length <= begin)
            result.marks.append(width, ' ');
        else if (at <= begin)
            result.marks += '^' + std::string(width - 1, '~');
        else if (at < end)
            result.marks.append(width, '~');
    }
    if (begin >= to) result.marks += '^';
    if (to < line.size()) result.text += "...";
    return result;
}

} // namespace yarte
