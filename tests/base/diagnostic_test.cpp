#include "yarte/base/diagnostic.h"

#include <gtest/gtest.h>

namespace yarte {
namespace {

struct DiagnosticTest : testing::Test {
    Span span(std::string_view place) const {
        const std::size_t begin = sources[scene].text().find(place);
        return {scene, begin, begin + place.size()};
    }
    std::string text(DiagnosticStyle style = DiagnosticStyle::plain) const {
        return format(diagnostics, sources, style);
    }

    Sources sources;
    SourceId scene = sources.add("scene.yarte", "up_vector 0 1 0\nsphere 0 0 0 -2\n");
    Diagnostics diagnostics;
};

TEST_F(DiagnosticTest, PointsIntoTheText) {
    diagnostics.error("scene.radius-not-positive", "radius must be positive, got -2", span("-2"));
    EXPECT_EQ(text(), "scene.yarte:2:14: error: radius must be positive, got -2 [scene.radius-not-positive]\n"
                      "    sphere 0 0 0 -2\n"
                      "                 ^~\n");
}

TEST_F(DiagnosticTest, NotesFollowTheirDiagnostic) {
    diagnostics.warning("x.y", "again", span("sphere"))
        .notes.push_back({"first given here", span("up_vector")});
    EXPECT_EQ(text(), "scene.yarte:2:1: warning: again [x.y]\n"
                      "    sphere 0 0 0 -2\n"
                      "    ^~~~~~\n"
                      "scene.yarte:1:1: note: first given here\n"
                      "    up_vector 0 1 0\n"
                      "    ^~~~~~~~~\n");
}

TEST_F(DiagnosticTest, WithoutATextTheFileTells) {
    diagnostics.error("x.y", "the file is binary").file = "a.yarte";
    diagnostics.error("x.z", "nothing to point to");
    EXPECT_EQ(text(), "a.yarte: error: the file is binary [x.y]\n"
                      "error: nothing to point to [x.z]\n");
}

TEST_F(DiagnosticTest, ColoursAreTheOnlyDifferenceOnATerminal) {
    diagnostics.error("x.y", "bad", span("-2"));
    diagnostics.warning("x.z", "odd");
    const std::string coloured = text(DiagnosticStyle::coloured);
    std::string stripped;
    for (std::size_t i = 0; i < coloured.size(); ++i) {
        if (coloured[i] == '\x1b')
            i = coloured.find('m', i);
        else
            stripped += coloured[i];
    }
    EXPECT_EQ(stripped, text());
    EXPECT_NE(coloured, text());
}

TEST_F(DiagnosticTest, Json) {
    diagnostics.error("x.y", "say \"a\\b\"\t\x01", span("-2")).notes.push_back({"here", span("sphere 0")});
    diagnostics.warning("x.z", "caf\xC3\xA9 \xFF").file = "f\xFE";
    EXPECT_EQ(
        text(DiagnosticStyle::json),
        R"({"severity": "error", "code": "x.y", "message": "say \"a\\b\"\u0009\u0001", "file": "scene.yarte", )"
        R"("line": 2, "column": 14, "endLine": 2, "endColumn": 16, "notes": [{"message": "here", )"
        R"("file": "scene.yarte", "line": 2, "column": 1, "endLine": 2, "endColumn": 9}]})"
        "\n"
        R"({"severity": "warning", "code": "x.z", "message": "café \ufffd", "file": "f\ufffd", "notes": []})"
        "\n");
}

TEST_F(DiagnosticTest, TerminalControlsAreReplaced) {
    diagnostics.error("x.y", "got '\x1b[2J'").file = "\x1b.yarte";
    EXPECT_EQ(text(), "\xEF\xBF\xBD.yarte: error: got '\xEF\xBF\xBD[2J' [x.y]\n");
}

TEST_F(DiagnosticTest, KeepsTwentyErrorsAndSaysThatThereAreMore) {
    for (int i = 0; i < Diagnostics::maxErrors; ++i) diagnostics.error("x.y", "bad");
    EXPECT_FALSE(diagnostics.full());
    EXPECT_EQ(text().find("note"), std::string::npos);
    diagnostics.error("x.y", "one more").notes.push_back({"goes with it", {}});
    EXPECT_TRUE(diagnostics.full());
    EXPECT_EQ(diagnostics.all().size(), 20U);
    EXPECT_EQ(text().substr(text().rfind("\n", text().size() - 2) + 1),
              "note: there are more errors; the first 20 are shown\n");
}

TEST_F(DiagnosticTest, WarningsAreNoErrors) {
    for (int i = 0; i < 50; ++i) diagnostics.warning("x.y", "odd");
    EXPECT_FALSE(diagnostics.hasErrors());
    EXPECT_FALSE(diagnostics.full());
    diagnostics.error("x.y", "bad");
    EXPECT_TRUE(diagnostics.hasErrors());
}

} // namespace
} // namespace yarte
