// The program yarte-validate as users see it, with fake renderers: shell scripts that the tests write.
#include "tests/validate/command_line.h"

#include <csignal>
#include <gmock/gmock.h>

namespace yarte::validate {
namespace {

using namespace std::string_literals;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;
using namespace test;

TEST_F(CommandLine, EqualPicturesPass) {
    EXPECT_EQ(validateScenes({"scene.yarte"}), 0);
    EXPECT_EQ(output_, "pass   scene  2x1  max 0.50/65535  0 px over  yarte 0.12 s  povray 0.25 s (2.0x)\n"
                       "1 case: 1 pass, 0 fail, 0 error\nreport: out/index.html\n");
    EXPECT_EQ(errors_, "");
    for (const char* file : {"index.html", "report.json", "junit.xml", "summary.md", "images/scene/yarte.png",
                             "images/scene/povray.png", "images/scene/difference.png",
                             "images/scene/yarte.pfm", "images/scene/povray.ppm", "images/scene/scene.pov"})
        EXPECT_TRUE(wrote(file)) << file;
    EXPECT_THAT(report(), HasSubstr("povray +Iscene.pov +Opovray.ppm +FP16 +W2 +H1 -D -A -P +WT"));
}

TEST_F(CommandLine, DifferentPicturesFail) {
    install("povray", with(fakePovray, wrongSteps));
    EXPECT_EQ(validateScenes({"scene.yarte"}), 1);
    EXPECT_THAT(output_, StartsWith("fail   scene  2x1  max 5.50/65535  1 px over"));
    EXPECT_THAT(report(),
                HasSubstr("1 of 2 pixels differ by more than 6.104e-05, the most at (1, 0): 8.392e-05"));
}

TEST_F(CommandLine, BrightScenesAreComparedAtLowerExposure) {
    install("yarte", with(fakeYarte, brightPixels));
    install("povray", with(fakePovray, brightSteps));
    EXPECT_EQ(validateScenes({"scene.yarte"}), 0) << output_;
    EXPECT_EQ(readFile(folder_ / "out/images/scene/scene.pov"), "// --exposure 0.25\n");
    EXPECT_THAT(report(), HasSubstr("\"exposure\": 0.25"));
}

TEST_F(CommandLine, SizeAndProcessesReachTheRenderers) {
    EXPECT_EQ(validateScenes({"scene.yarte"}, {"--size", "2x1", "--processes", "3"}), 0);
    EXPECT_THAT(report(), HasSubstr("--size 2x1 --processes 3\""));
    EXPECT_THAT(report(), HasSubstr("+WT3 "));
}

TEST_F(CommandLine, ErrorsOfASceneAreShownAndTheOthersStillRun) {
    install("yarte", "#!/bin/sh\ncase $1 in *bad*) echo 'bad.yarte:1:1: error: no' >&2; exit 1 ;; esac\n" +
                         with(fakeYarte, dimPixels).substr(10));
    EXPECT_EQ(validateScenes({"bad.yarte", "scene.yarte"}), 3);
    EXPECT_THAT(output_,
                StartsWith("error  bad  yarte: exit code 1\n       bad.yarte:1:1: error: no\npass   scene"));
    EXPECT_THAT(output_, HasSubstr("2 cases: 1 pass, 0 fail, 1 error"));
}

TEST_F(CommandLine, ErrorOutranksFail) {
    install("povray", with(fakePovray, wrongSteps));
    install("yarte", "#!/bin/sh\ncase $1 in *bad*) exit 1 ;; esac\n" + with(fakeYarte, dimPixels).substr(10));
    EXPECT_EQ(validateScenes({"scene.yarte", "bad.yarte"}), 3);
    EXPECT_THAT(output_, HasSubstr("2 cases: 0 pass, 1 fail, 1 error"));
}

TEST_F(CommandLine, MissingPrograms) {
    EXPECT_EQ(validate({"scene.yarte", "-o", "out", "--yarte", "./yarte", "--convert", "./yarte-convert"}),
              3);
    EXPECT_EQ(output_.substr(0, output_.find('\n')),
              "error  scene  2x1  povray not found: install it, or give its place with --povray");
    EXPECT_TRUE(wrote("images/scene/yarte.png")) << "what there is can be looked at";
    EXPECT_EQ(validateScenes({"scene.yarte"}, {"--povray", "./nowhere"}), 2) << "given twice";
    std::filesystem::remove(folder_ / "povray");
    EXPECT_EQ(validateScenes({"scene.yarte"}), 3);
    EXPECT_THAT(output_, StartsWith("error  scene  2x1  povray: not started: No such file or directory"));
}

TEST_F(CommandLine, PovrayThatCrashes) {
    install("povray", "#!/bin/sh\nkill -SEGV $$\n");
    EXPECT_EQ(validateScenes({"scene.yarte"}), 3);
    EXPECT_THAT(output_, StartsWith("error  scene  2x1  povray: killed by signal 11 (Segmentation fault)"));
}

TEST_F(CommandLine, PovrayThatRefusesTheScene) {
    install(
        "povray",
        "#!/bin/sh\nfor a; do case $a in +GF*) echo 'Parse Error: what is this' > ${a#+GF} ;; esac; done\n"
        "echo banner >&2; exit 1\n");
    EXPECT_EQ(validateScenes({"scene.yarte"}), 3);
    EXPECT_THAT(output_,
                StartsWith("error  scene  2x1  povray: exit code 1\n       Parse Error: what is this\n"));
    EXPECT_THAT(output_, Not(HasSubstr("banner")));
}

TEST_F(CommandLine, PovrayThatHangs) {
    install("povray", "#!/bin/sh\nexec /bin/sleep 600\n");
    EXPECT_EQ(validateScenes({"scene.yarte"}, {"--time-limit", "0.5"}), 3);
    EXPECT_THAT(output_, StartsWith("error  scene  2x1  povray: stopped after 0.5 s, the time limit\n"));
}

/// A POV-Ray that first takes so many GiB of address space, which no machine has to have.
std::string greedyPovray(int gibibytes) {
    return "#!/bin/sh\n/usr/bin/python3 -c 'import mmap; mmap.mmap(-1, " + std::to_string(gibibytes) +
           " << 30, flags=mmap.MAP_PRIVATE | mmap.MAP_ANONYMOUS | 0x4000)' || exit 9\n" +
           with(fakePovray, dimSteps).substr(10);
}

TEST_F(CommandLine, PovrayThatTakesTooMuchMemory) {
    if (!std::filesystem::exists("/usr/bin/python3")) GTEST_SKIP() << "skipped: no python3";
    install("povray", greedyPovray(7));
    EXPECT_EQ(validateScenes({"scene.yarte"}), 0) << output_;
    install("povray", greedyPovray(9));
    EXPECT_EQ(validateScenes({"scene.yarte"}), 3);
    EXPECT_THAT(output_, StartsWith("error  scene  2x1  povray: exit code 9\n"));
    EXPECT_THAT(output_, HasSubstr("Cannot allocate memory"));
}

TEST_F(CommandLine, PovrayThatWritesNothing) {
    install("povray", "#!/bin/sh\n");
    EXPECT_EQ(validateScenes({"scene.yarte"}), 3);
    EXPECT_THAT(output_,
                StartsWith("error  scene  2x1  povray ended well but wrote no picture (povray.ppm)\n"));
}

TEST_F(CommandLine, PovrayThatWritesHalfAPicture) {
    install("povray", with(fakePovray, "abc"));
    EXPECT_EQ(validateScenes({"scene.yarte"}), 3);
    EXPECT_THAT(output_, HasSubstr("it ends after 3 of 12 bytes of pixels"));
}

TEST_F(CommandLine, PovrayThatWritesAnotherSize) {
    install("povray",
            "#!/bin/sh\nfor a; do case $a in +O*) printf 'P6\\n1 1\\n255\\nabc' > ${a#+O} ;; esac; done\n");
    EXPECT_EQ(validateScenes({"scene.yarte"}), 3);
    EXPECT_THAT(output_, HasSubstr("sizes differ: yarte's picture is 2x1, POV-Ray's picture is 1x1"));
}

TEST_F(CommandLine, ConverterThatFails) {
    install("yarte-convert", "#!/bin/sh\necho 'cannot say this in SDL' >&2; exit 1\n");
    EXPECT_EQ(validateScenes({"scene.yarte"}), 3);
    EXPECT_THAT(output_,
                StartsWith("error  scene  2x1  yarte-convert: exit code 1\n       cannot say this in SDL\n"));
}

TEST_F(CommandLine, ValuesThatAreNotFinite) {
    install("yarte", with(fakeYarte, nanPixels));
    EXPECT_EQ(validateScenes({"scene.yarte"}), 3);
    EXPECT_THAT(output_, HasSubstr("yarte's picture has nan or infinity in 1 pixel, the first at (1, 0)"));
}

TEST_F(CommandLine, NothingOfAnEarlierRunRemains) {
    EXPECT_EQ(validateScenes({"scene.yarte"}), 0);
    writeFile(folder_ / "out/images/scene/notes.txt", "mine");
    install("yarte", "#!/bin/sh\nexit 1\n");
    EXPECT_EQ(validateScenes({"scene.yarte"}), 3);
    EXPECT_FALSE(wrote("images/scene/povray.png"));
    EXPECT_TRUE(wrote("images/scene/notes.txt"));
}

TEST_F(CommandLine, ScenesOfOneNameAreKeptApart) {
    for (const char* name : {"a", "b"}) {
        std::filesystem::create_directory(folder_ / name);
        writeFile(folder_ / name / "s.yarte", "");
    }
    EXPECT_EQ(validateScenes({"a/s.yarte", "b/s.yarte"}), 0);
    EXPECT_TRUE(wrote("images/a-s/yarte.png"));
    EXPECT_TRUE(wrote("images/b-s/yarte.png"));
}

TEST_F(CommandLine, FoldersThatCannotBeWritten) {
    EXPECT_EQ(validate({"scene.yarte", "-o", "scene.yarte/out"}), 3);
    EXPECT_EQ(errors_, "yarte-validate: scene.yarte/out: Not a directory\n");
    EXPECT_EQ(validate({"scene.yarte", "-o", "scene.yarte/out", "--diagnostics", "json"}), 3);
    EXPECT_THAT(errors_, HasSubstr("\"validate.could-not-run\""));
}

TEST_F(CommandLine, AnInterruptLeavesNothing) {
    install("povray", "#!/bin/sh\necho $$ > \"" + (folder_ / "pid").string() +
                          "\"; kill -INT $PPID; exec /bin/sleep 600\n");
    EXPECT_EQ(validateScenes({"scene.yarte"}), 130);
    EXPECT_EQ(errors_, "yarte-validate: interrupted\n");
    EXPECT_FALSE(wrote("report.json"));
    EXPECT_NE(::kill(std::stoi(readFile(folder_ / "pid")), 0), 0) << "the renderer still runs";
}

TEST_F(CommandLine, Images) {
    writeFile(folder_ / "a.ppm", "P6\n1 1\n65535\n\x40\x00\x40\x00\x40\x00"s);
    writeFile(folder_ / "b.ppm", "P6\n1 1\n65535\n\x40\x04\x40\x00\x40\x00"s);
    writeFile(folder_ / "c.ppm", "P6\n1 1\n65535\n\x40\x05\x40\x00\x40\x00"s);
    EXPECT_EQ(validate({"images", "a.ppm", "b.ppm", "-o", "out"}), 0);
    EXPECT_THAT(output_, StartsWith("pass   a-b  1x1  max 4.00/65535  0 px over\n"));
    EXPECT_THAT(report(), HasSubstr("\"encoding\": \"All images were read as linear"));
    EXPECT_TRUE(wrote("images/a-b/difference.png"));
    EXPECT_EQ(validate({"images", "-o", "out", "a.ppm", "c.ppm"}), 1);
    EXPECT_THAT(output_, StartsWith("fail   a-c  1x1  max 5.00/65535  1 px over\n1 case: "))
        << "nothing is known of a scene, and no line is spent on it";
    // The slope of sRGB's decoding at 0.25 is 2.4/1.055 (0.305/1.055)^1.4 = 0.400.
    EXPECT_EQ(validate({"images", "a.ppm", "c.ppm", "--srgb", "-o", "out"}), 0);
    EXPECT_THAT(output_, StartsWith("pass   a-c  1x1  max 2.00/65535"));
    EXPECT_THAT(report(), HasSubstr("\"encoding\": \"Integer images were read as sRGB"));
    EXPECT_EQ(validate({"images", "a.ppm", "none.ppm", "-o", "out"}), 3);
    EXPECT_THAT(output_, StartsWith("error  a-none  none.ppm: "));
}

TEST_F(CommandLine, WrongUsage) {
    EXPECT_EQ(validate({}), 2);
    EXPECT_EQ(validate({"scene.yarte"}), 2);
    EXPECT_EQ(validate({"-o", "out"}), 2);
    EXPECT_THAT(errors_, HasSubstr("SCENE is required"));
    EXPECT_EQ(validate({"scene.yarte", "images", "a", "b", "-o", "out"}), 2);
    EXPECT_EQ(validate({"images", "a", "-o", "out"}), 2);
    for (const char* size : {"", "0x1", "1x", "x1", "1x1x1", "-1x1", "9999999999x1"})
        EXPECT_EQ(validateScenes({"scene.yarte"}, {"--size", size}), 2) << size;
    EXPECT_EQ(validateScenes({"scene.yarte"}, {"--processes", "-1"}), 2);
    EXPECT_FALSE(wrote("report.json"));
}

TEST_F(CommandLine, HelpAndVersion) {
    EXPECT_EQ(validate({"--help"}), 0);
    EXPECT_THAT(output_, HasSubstr("--povray"));
    EXPECT_EQ(validate({"--version"}), 0);
    EXPECT_THAT(output_, StartsWith("yarte-validate "));
}

} // namespace
} // namespace yarte::validate
