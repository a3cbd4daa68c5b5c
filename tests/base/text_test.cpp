#include "yarte/base/text.h"

#include <gtest/gtest.h>

#include <array>

namespace yarte {
namespace {

TEST(Utf8, LengthOfTheFirstCharacter) {
    EXPECT_EQ(utf8CharacterLength("a"), 1U);
    EXPECT_EQ(utf8CharacterLength("\xC3\xA9t"), 2U);
    EXPECT_EQ(utf8CharacterLength("\xE2\x82\xAC"), 3U);
    EXPECT_EQ(utf8CharacterLength("\xF0\x9F\x98\x80"), 4U);
    EXPECT_EQ(utf8CharacterLength(""), 0U);
}

TEST(Utf8, InvalidBytesHaveNone) {
    for (const char* text : {"\x80", "\xC3", "\xC3(", "\xC0\x80", "\xC1\xBF", "\xE0\x80\x80", "\xED\xA0\x80",
                             "\xF0\x80\x80\x80", "\xF4\x90\x80\x80", "\xF5\x80\x80\x80", "\xFF", "\xE2\x82"})
        EXPECT_EQ(utf8CharacterLength(text), 0U);
}

TEST(Printable, ReplacesWhatATerminalMustNotGet) {
    EXPECT_EQ(printable("caf\xC3\xA9"), "caf\xC3\xA9");
    EXPECT_EQ(printable("\x1b[31m"), "\xEF\xBF\xBD[31m");
    EXPECT_EQ(printable("a\xC2\x9B"
                        "b\x7F\xFF"),
              "a\xEF\xBF\xBD"
              "b\xEF\xBF\xBD\xEF\xBF\xBD");
}

TEST(InQuotes, ShortensAtACharacter) {
    EXPECT_EQ(inQuotes("12x"), "'12x'");
    EXPECT_EQ(inQuotes(std::string(40, 'a')), "'" + std::string(40, 'a') + "'");
    EXPECT_EQ(inQuotes(std::string(41, 'a')), "'" + std::string(40, 'a') + "...'");
    std::string accents, forty;
    for (int i = 0; i < 60; ++i) accents += "\xC3\xA9", forty = i == 39 ? accents : forty;
    EXPECT_EQ(inQuotes(accents), "'" + forty + "...'");
}

TEST(ClosestWord, FindsWhatWasMeant) {
    constexpr std::array<std::string_view, 5> words{"sphere", "box", "cone", "backface_colour",
                                                    "background_colour"};
    EXPECT_EQ(closestWord("shpere", words), "sphere");
    EXPECT_EQ(closestWord("SPHERE", words), "sphere");
    EXPECT_EQ(closestWord("spheres", words), "sphere");
    EXPECT_EQ(closestWord("bxo", words), "box");
    EXPECT_EQ(closestWord("backface_color", words), "backface_colour");
    EXPECT_EQ(closestWord("background", words), std::nullopt);
    EXPECT_EQ(closestWord("teapot", words), std::nullopt);
    EXPECT_EQ(closestWord("", words), std::nullopt);
    EXPECT_EQ(closestWord(std::string(100000, 's'), words), std::nullopt);
}

TEST(ClosestWord, OfEquallyNearWordsTheFirst) {
    constexpr std::array<std::string_view, 2> words{"cone", "bone"};
    EXPECT_EQ(closestWord("done", words), "cone");
}

} // namespace
} // namespace yarte
