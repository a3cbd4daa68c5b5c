#include "yarte/lang/lexer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace yarte {
namespace {

using testing::ElementsAre;
using testing::Pair;

std::vector<std::pair<TokenKind, std::string>> tokens(const std::string& text) {
    Sources sources;
    const SourceId id = sources.add("x", text);
    std::vector<std::pair<TokenKind, std::string>> result;
    for (Lexer lexer(id, sources[id]); lexer.current().kind != TokenKind::end; lexer.advance()) {
        const Token& token = lexer.current();
        EXPECT_EQ(sources[id].text().substr(token.span.begin, token.span.end - token.span.begin), token.text);
        result.emplace_back(token.kind, token.text);
    }
    return result;
}

TEST(Lexer, WhiteSpaceAndCommentsSeparate) {
    EXPECT_THAT(tokens("a b\tc\r\nd\fe\vf;g\n;h\nh"),
                ElementsAre(Pair(TokenKind::word, "a"), Pair(TokenKind::word, "b"),
                            Pair(TokenKind::word, "c"), Pair(TokenKind::word, "d"),
                            Pair(TokenKind::word, "e"), Pair(TokenKind::word, "f"),
                            Pair(TokenKind::word, "h")));
    EXPECT_TRUE(tokens("").empty());
    EXPECT_TRUE(tokens("; only a comment").empty());
}

TEST(Lexer, TellsNumbersFromWhatLooksLikeThem) {
    EXPECT_THAT(tokens("1 -.5 +2e3 200."), testing::Each(Pair(TokenKind::number, testing::_)));
    EXPECT_THAT(tokens("1e 0x10 1,5 - + . nan -INF +infinity 12abc"),
                testing::Each(Pair(TokenKind::badNumber, testing::_)));
    EXPECT_THAT(tokens("1e999 -1e400"), testing::Each(Pair(TokenKind::hugeNumber, testing::_)));
    EXPECT_THAT(tokens("sphere info nano -x e5 a1 infinite"),
                testing::Each(Pair(TokenKind::word, testing::_)));
}

TEST(Lexer, QuotedNamesEndOnTheirLine) {
    EXPECT_THAT(tokens("\"a;b c\" \"a\"\"b\" \"\""),
                ElementsAre(Pair(TokenKind::quotedName, "\"a;b c\""),
                            Pair(TokenKind::quotedName, "\"a\"\"b\""), Pair(TokenKind::quotedName, "\"\"")));
    EXPECT_THAT(tokens("\"a b\nc"),
                ElementsAre(Pair(TokenKind::unclosedName, "\"a b"), Pair(TokenKind::word, "c")));
    EXPECT_THAT(tokens("\""), ElementsAre(Pair(TokenKind::unclosedName, "\"")));
    EXPECT_THAT(tokens("a\"b c\""), ElementsAre(Pair(TokenKind::word, "a\"b"), Pair(TokenKind::word, "c\"")));
}

} // namespace
} // namespace yarte
