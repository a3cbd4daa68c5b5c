#include "validate/text.h"

#include "tests/validate/support.h"
#include "validate/case_names.h"
#include "validate/renderers.h"

#include <gmock/gmock.h>

namespace yarte::validate {
namespace {

TEST(Text, CleanTextKeepsUtf8AndReplacesTheRest) {
    EXPECT_EQ(cleanText("a\tb\né€😀"), "a\tb\né€😀");
    EXPECT_EQ(cleanText("\x1b[31mred\r\n"), "\uFFFD[31mred\uFFFD\n");
    EXPECT_EQ(cleanText(std::string_view("\0\x7f\xff\xc3", 4)), "\uFFFD\uFFFD\uFFFD\uFFFD");
}

TEST(Text, ShellCommandsQuoteWhatAShellWouldRead) {
    EXPECT_EQ(shellCommand({"/bin/yarte", "+Ia.pov", "--size", "1x2"}), "/bin/yarte +Ia.pov --size 1x2");
    EXPECT_EQ(shellCommand({"a b", "it's", "", "$HOME"}), "'a b' 'it'\\''s' '' '$HOME'");
}

TEST(Text, TrimmedEnd) {
    EXPECT_EQ(trimmedEnd(" a \n\t\n"), " a");
    EXPECT_EQ(trimmedEnd("\n"), "");
}

TEST(CaseNames, AreStemsUnlessThoseAreTaken) {
    EXPECT_THAT(caseNames({"scenes/paper/paper.yarte", "b/glass.gltf"}),
                testing::ElementsAre("paper", "glass"));
    EXPECT_THAT(caseNames({"a/scene.yarte", "b/scene.yarte", "c.yarte"}),
                testing::ElementsAre("a-scene", "b-scene", "c"));
    EXPECT_THAT(caseNames({"a/scene.yarte", "a/scene.pov", "x/a/scene.yarte"}),
                testing::ElementsAre("a-scene", "a-scene-2", "a-scene-3"));
    EXPECT_THAT(caseNames({"a/s.yarte", "b/s.yarte", "a-s.yarte"}),
                testing::ElementsAre("a-s", "b-s", "a-s-2"));
}

TEST(CaseNames, AreSafeAsFolders) {
    EXPECT_EQ(folderName("größe 1/2"), "gr____e_1_2");
    EXPECT_EQ(folderName(".."), "_..");
    EXPECT_EQ(folderName(""), "_");
}

TEST(PovrayStatistics, SecondsAreThoseInParentheses) {
    const std::string statistics = "Parser Time\n"
                                   "  Parse Time:       0 hours  0 minutes  0 seconds (0.091 seconds)\n"
                                   "Render Time:\n"
                                   "  Photon Time:      No photons\n"
                                   "  Trace Time:       0 hours  1 minutes  2 seconds (62.500 seconds)\n";
    EXPECT_EQ(povraySeconds(statistics, "Parse Time"), 0.091);
    EXPECT_EQ(povraySeconds(statistics, "Trace Time"), 62.5);
    EXPECT_EQ(povraySeconds(statistics, "Photon Time"), std::nullopt);
    EXPECT_EQ(povraySeconds(statistics, "Bounding Time"), std::nullopt);
    EXPECT_EQ(povraySeconds("Parse Time: (x seconds)", "Parse Time"), std::nullopt);
}

} // namespace
} // namespace yarte::validate
