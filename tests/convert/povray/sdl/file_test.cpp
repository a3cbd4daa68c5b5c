// Files that a program writes and reads: as POV-Ray does, and only where it may.
#include "tests/convert/povray/sdl/run.h"
#include "tests/support/povray.h"
#include "tests/support/program.h"
#include "yarte/base/file.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <sstream>

namespace yarte::convert::povray::sdl::test {
namespace {

namespace fs = std::filesystem;

/// Prints every value of a file by a #while of #reads: `names` at a time, `show` makes a string of V.
std::string reading(const std::string& file, const char* initial, const char* show, bool pairs = false) {
    return fmt::format(
        "#debug \"\\n@{0}\\n\" #fopen F \"{0}\" read #declare N = 0;\n"
        "#while (defined(F) & N < 12) #declare N = N + 1; #declare V = {1}; #declare W = {1};\n"
        "#read (F, V{2}) #debug concat(\"\\n@\", {3}, \"\\n\") {4}#end\n"
        "#ifdef (F) #debug \"\\n@still open\\n\" #end #fclose F\n",
        file, initial, pairs ? ", W" : "", show,
        pairs ? "#debug concat(\"\\n@\", str(W, 0, 3), \"\\n\") " : "");
}

std::string program() {
    std::string text = R"(#version 3.7;
#fopen Out "out.txt" write
#write (Out, "a\n", 1, ",", 2.5, " ", 1/3, " ", 1e10, " ", 1e-10, " ", 123456789, " ", -5, 1000000, true, pi, "\n")
#write (Out <1, 2, 3>, <0.1, 2/3, 1e7>, <1, 2>, <1, 2, 3, 4, 5>, x, concat("q\"", "x"))
#fclose Out
#ifdef (Out) #debug "\n@open\n" #else #debug "\n@closed\n" #end
#fopen Out "out.txt" append
#write (Out, "more")
#fclose Out
#fopen Round "round.txt" write
#write (Round, "\"one\",", 2, ",", <1, -2, 3.5>, ",", 0)
#fclose Round
#fopen Round "round.txt" read
#read (Round, A, B, C, D)
#debug concat("\n@", A, str(B, 0, 3), vstr(3, C, ",", 0, 3), str(D, 0, 3), "\n")
#ifdef (Round) #debug "\n@open\n" #else #debug "\n@at its end\n" #end
#fopen Code "code.inc" write
#write (Code, "#debug \"\\n@included\\n\" sphere { 0, 1 }")
#fclose Code
#include "code.inc"
#debug concat("\n@", str(file_exists("code.inc"), 0, 0), str(file_exists("none.inc"), 0, 0), "\n")
)";
    const char* number = "str(V, 0, 3)";
    for (const char* file :
         {"commas.txt", "trailing.txt", "blanks.txt", "empty.txt", "signs.txt", "comments.txt"})
        text += reading(file, "-99", number);
    for (const char* file : {"commas.txt", "trailing.txt", "blanks.txt"})
        text += reading(file, "-99", number, true);
    text += reading("strings.txt", "\"none\"", "V");
    text += reading("vectors.txt", "<9, 9, 9>", "vstr(3, V, \" \", 0, 3)");
    return text;
}

void writeData(const fs::path& folder) {
    fs::create_directory(folder);
    writeFile(folder / "scene.pov", program());
    writeFile(folder / "commas.txt", "1, 2, 3");
    writeFile(folder / "trailing.txt", "1, 2, 3,\n");
    writeFile(folder / "blanks.txt", "1 2\n3\n\n");
    writeFile(folder / "empty.txt", "");
    writeFile(folder / "signs.txt", "-1, +2 -.5e1, 3.,4");
    writeFile(folder / "comments.txt", "1, // one\n /* two */ 2, 3");
    writeFile(folder / "strings.txt", "\"a\", \"b c\"\n\"passed over\"\n\"d\", \"e\\nf\"");
    writeFile(folder / "vectors.txt", "<1,2,3>, <4,5,6>\n,<-7,+8,.9>");
}

TEST(SdlFile, IsReadAndWrittenAsByPovray) {
    if (!yarte::test::hasPovray()) GTEST_SKIP() << "skipped: povray not found";
    const fs::path folder = yarte::test::emptyTestFolder(), theirs = folder / "theirs",
                   ours = folder / "ours";
    writeData(theirs), writeData(ours);
    const auto [status, said] = yarte::test::runPovray(theirs, "+Iscene.pov -F -D +W4 +H4");
    ASSERT_EQ(status, 0) << said;
    const SdlRun run(program(), ours / "scene.pov", {}, ours);
    ASSERT_TRUE(run.model) << run.problems();
    EXPECT_EQ(markedLines(run.printed), markedLines(said));
    EXPECT_GE(markedLines(run.printed).size(), 50U);
    for (const char* file : {"out.txt", "round.txt", "code.inc"})
        EXPECT_EQ(readFile(ours / file), readFile(theirs / file));
}

TEST(SdlFile, IsWrittenOnlyWhereTheUserAllows) {
    const fs::path folder = yarte::test::emptyTestFolder(), allowed = folder / "allowed";
    fs::create_directory(allowed);
    fs::create_directory_symlink(folder, allowed / "link");
    const auto writing = [](const std::string& name) {
        return "#fopen F \"" + name + "\" write #write (F, 1) sphere { 0, 1 }";
    };
    for (const std::string& outside : {std::string("../x"), std::string("link/x"), (folder / "x").string()}) {
        const SdlRun run(writing(outside), folder / "scene.pov", {}, allowed);
        EXPECT_NE(run.problems().find("sdl.file-access"), std::string::npos) << outside;
    }
    EXPECT_NE(SdlRun(writing("x"), folder / "scene.pov").problems().find("--allow-write"), std::string::npos);
    EXPECT_FALSE(fs::exists(folder / "x"));
    EXPECT_FALSE(fs::exists(allowed / "x"));
    // Not closed: at the end of the program.
    EXPECT_TRUE(SdlRun(writing("x"), folder / "scene.pov", {}, allowed).model);
    EXPECT_EQ(readFile(allowed / "x"), "1");
    EXPECT_NE(SdlRun("#fopen F \"../x\" read", allowed / "scene.pov").problems().find("sdl.include-"),
              std::string::npos);
}

TEST(SdlFile, WhatIsWrongIsTold) {
    const fs::path folder = yarte::test::emptyTestFolder();
    writeFile(folder / "data.txt", "1, word");
    const auto problems = [&](const std::string& text, const Limits& limits = {}) {
        return SdlRun(text, folder / "scene.pov", limits, folder).problems();
    };
    EXPECT_NE(problems("#fopen F \"data.txt\" read #read (F, A) #read (F, A)").find("data.txt:1:4: error"),
              std::string::npos);
    EXPECT_NE(problems("#fopen F \"data.txt\" read #write (F, 1)").find("sdl.no-file"), std::string::npos);
    EXPECT_NE(problems("#fopen F \"out.txt\" write #read (F, A)").find("sdl.no-file"), std::string::npos);
    EXPECT_NE(problems("#read (F, A)").find("sdl.no-file"), std::string::npos);
    Limits limits;
    limits.written = 100'000;
    EXPECT_NE(
        problems("#while (1) #fopen F \"out.txt\" write #fclose F #end", limits).find("sdl.writes-too-much"),
        std::string::npos);
    EXPECT_NE(problems("#fopen F \"o.txt\" write #while (1) #write (F, 123456) #end", limits)
                  .find("sdl.writes-too-much"),
              std::string::npos);
}

} // namespace
} // namespace yarte::convert::povray::sdl::test
