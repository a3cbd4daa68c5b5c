#include "yarte/base/source.h"

#include <gtest/gtest.h>

namespace yarte {
namespace {

TEST(Source, CountsLinesAndColumnsFromOne) {
    const Source source("x", "ab\ncd\n");
    const auto expectAt = [&](std::size_t offset, std::size_t line, std::size_t column) {
        EXPECT_EQ(source.position(offset).line, line) << offset;
        EXPECT_EQ(source.position(offset).column, column) << offset;
    };
    expectAt(0, 1, 1);
    expectAt(2, 1, 3); // the line end belongs to its line
    expectAt(3, 2, 1);
    expectAt(6, 3, 1); // the end of the text
}

TEST(Source, LinesComeWithoutTheirEnds) {
    const Source source("x", "one\r\n\r\ntwo\nlast");
    EXPECT_EQ(source.line(1), "one");
    EXPECT_EQ(source.line(2), "");
    EXPECT_EQ(source.line(3), "two");
    EXPECT_EQ(source.line(4), "last");
    EXPECT_EQ(source.line(0), "");
    EXPECT_EQ(source.line(5), "");
}

TEST(Source, EmptyTextHasOneEmptyLine) {
    const Source source("x", "");
    EXPECT_EQ(source.position(0).line, 1U);
    EXPECT_EQ(source.position(0).column, 1U);
    EXPECT_EQ(source.line(1), "");
}

TEST(Source, ByteOrderMarkIsDropped) {
    const Source source("x", "\xEF\xBB\xBFsphere");
    EXPECT_EQ(source.text(), "sphere");
    EXPECT_EQ(source.position(0).column, 1U);
}

TEST(Sources, ReferencesStayValid) {
    Sources sources;
    const Source& first = sources[sources.add("first", "1")];
    for (int i = 0; i < 1000; ++i) sources.add("more", "text");
    EXPECT_EQ(first.name(), "first");
    EXPECT_FALSE(SourceId{}.valid());
}

} // namespace
} // namespace yarte
