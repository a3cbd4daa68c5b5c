#include "yarte/base/excerpt.h"

#include <gtest/gtest.h>

namespace yarte {
namespace {

/// The excerpt for the first occurrence of `place` in `text`.
Excerpt around(const std::string& text, const std::string& place) {
    Sources sources;
    const SourceId id = sources.add("x", text);
    const std::size_t begin = sources[id].text().find(place);
    return excerpt(sources[id], {id, begin, begin + place.size()});
}

void expectExcerpt(const Excerpt& got, const std::string& text, const std::string& marks) {
    EXPECT_EQ(got.text, text);
    EXPECT_EQ(got.marks, marks);
}

TEST(Excerpt, MarksTheSpan) {
    expectExcerpt(around("one\nsphere 0 0 0 -2\ntwo", "-2"), "sphere 0 0 0 -2", "             ^~");
    expectExcerpt(around("abc", "a"), "abc", "^");
}

TEST(Excerpt, TabsAreExpandedInBothLines) {
    expectExcerpt(around("\tsphere\t0", "0"), "    sphere  0", "            ^");
    expectExcerpt(around("a 1\t2 b", "1\t2"), "a 1 2 b", "  ^~~");
}

TEST(Excerpt, CharactersCountNotBytes) {
    expectExcerpt(around("caf\xC3\xA9 \xE2\x82\xAC 1", "1"), "caf\xC3\xA9 \xE2\x82\xAC 1", "       ^");
    expectExcerpt(around("x \xC3\xA9\xC3\xA9 y", "\xC3\xA9\xC3\xA9"), "x \xC3\xA9\xC3\xA9 y", "  ^~");
}

TEST(Excerpt, InvalidBytesAndControlsTakeOneColumn) {
    expectExcerpt(around("\xFF\x1b 1", "1"), "\xEF\xBF\xBD\xEF\xBF\xBD 1", "   ^");
}

TEST(Excerpt, SpanOfSeveralLinesEndsWithItsFirst) {
    expectExcerpt(around("polygon 3\r\n0 0 0", "3\r\n0"), "polygon 3", "        ^");
}

TEST(Excerpt, EndOfTextIsMarkedBehindIt) {
    Sources sources;
    const SourceId id = sources.add("x", "ab");
    expectExcerpt(excerpt(sources[id], {id, 2, 2}), "ab", "  ^");
    const SourceId empty = sources.add("x", "");
    expectExcerpt(excerpt(sources[empty], {empty, 0, 0}), "", "^");
}

TEST(Excerpt, LongLinesAreCutAroundThePlace) {
    const std::string before(1000, 'a'), after(1000, 'b');
    expectExcerpt(around(before + " X " + after, "X"),
                  "..." + std::string(39, 'a') + " X " + std::string(58, 'b') + "...",
                  std::string(43, ' ') + "^");
    expectExcerpt(around("X" + after, "X"), "X" + std::string(59, 'b') + "...", "^");
    expectExcerpt(around(before + "X", "X"), "..." + std::string(40, 'a') + "X", std::string(43, ' ') + "^");
}

TEST(Excerpt, ACutNeverSplitsACharacter) {
    std::string line;
    for (int i = 0; i < 200; ++i) line += "\xE2\x82\xAC";
    for (int shift = 0; shift < 3; ++shift) {
        const Excerpt got =
            around(std::string(static_cast<std::size_t>(shift), 'a') + line + "X" + line, "X");
        EXPECT_EQ(got.text.find("\xEF\xBF\xBD"), std::string::npos) << shift;
        EXPECT_EQ(got.marks.back(), '^');
    }
}

} // namespace
} // namespace yarte
