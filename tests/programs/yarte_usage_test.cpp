// The program `yarte`: help, wrong usage, and what is wrong with files: exit codes and messages.
#include "tests/programs/yarte_program.h"

#include "yarte/version.h"

#include <gmock/gmock.h>

#include <unistd.h>

namespace yarte::test {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::MatchesRegex;
using testing::StartsWith;

TEST_F(Yarte, HelpNamesEveryOptionAndVersionTheVersion) {
    const auto help = yarte({"--help"});
    EXPECT_EQ(help.exitCode, 0);
    EXPECT_EQ(help.err, "");
    for (const char* option : {"SCENE",
                               "--help",
                               "--version",
                               "-o,",
                               "--size WxH",
                               "--region X0,Y0,X1,Y1",
                               "--processes N",
                               "--threads N",
                               "--tile N",
                               "--samples N",
                               "--depth 8|16",
                               "--linear",
                               "--half",
                               "--big-endian",
                               "--allow-path DIR",
                               "--precision double|fast",
                               "--progress auto|bar|json|none",
                               "--stats FILE",
                               "--checkpoint FILE",
                               "--resume",
                               "--partial",
                               "--diagnostics text|json"})
        EXPECT_THAT(help.out, HasSubstr(option));
    const auto version = yarte({"--version"});
    EXPECT_EQ(version.exitCode, 0);
    EXPECT_EQ(version.out, std::string("yarte ") + yarte::version + "\n");
    EXPECT_THAT(namesIn(folder_), IsEmpty());
}

TEST_F(Yarte, WrongUsageIsExitCode2AndSaysWhat) {
    write("s.yarte", sphereScene);
    write("s.png", sphereScene);
    struct Case {
        std::vector<std::string> arguments;
        std::string message; ///< after "yarte: "
    };
    const Case cases[] = {
        {{}, "SCENE is required"},
        {{"s.yarte", "t.yarte"}, "The following argument was not expected: t.yarte"},
        {{"s.yarte", "--colour", "x.exr"}, "The following arguments were not expected"},
        {{"s.yarte", "--aov", "x.png"}, "--aov: x.png: must end in .exr"},
        {{"s.yarte", "--aov", "s.yarte"}, "--aov: s.yarte: must end in .exr"},
        {{"s.yarte", "-o", "a.tga"},
         "--output: a.tga: unknown image format; known are .png .ppm .pfm .exr .dmp"},
        {{"s.yarte", "-o"}, "--output: 1 required FILE missing"},
        {{"s.png", "-o", "./s.png"}, "./s.png: the output is the scene itself"},
        {{"s.png"}, "s.png: the output is the scene itself"},
        {{"s.yarte", "--stats", "s.yarte"}, "s.yarte: the statistics would overwrite the scene"},
        {{"s.yarte", "--processes", "2", "--threads", "2"}, "--processes excludes --threads"},
        {{"s.yarte", "--processes", "-1"}, "--processes: expected a whole number of at least 0, got '-1'"},
        {{"s.yarte", "--threads", "0"}, "--threads: expected a whole number of at least 1, got '0'"},
        {{"s.yarte", "--tile", "0"}, "--tile: expected a whole number of at least 1, got '0'"},
        {{"s.yarte", "--samples", "0"}, "--samples: expected a whole number from 1 to 256, got '0'"},
        {{"s.yarte", "--samples", "257"}, "--samples: expected a whole number from 1 to 256, got '257'"},
        {{"s.yarte", "--depth", "10"}, "--depth: 10 not in {8,16}"},
        {{"s.yarte", "--precision", "float"}, "--precision: float not in {double,fast}"},
        {{"s.yarte", "--progress", "much"}, "--progress: much not in {auto,bar,json,none}"},
        {{"s.yarte", "--diagnostics", "xml"}, "--diagnostics: xml not in {text,json}"},
        {{"s.yarte", "--size", "640"}, "--size: expected WxH, like 640x480, got '640'"},
        {{"s.yarte", "--size", "0x480"}, "--size: image width must be from 1 to 1048576 pixels, got 0"},
        {{"s.yarte", "--size", "4x99999999999"}, "--size: expected WxH, like 640x480, got '4x99999999999'"},
        {{"s.yarte", "--region", "1,2,3"}, "--region: expected X0,Y0,X1,Y1, got '1,2,3'"},
        {{"s.yarte", "--region", "1,2,1,4"}, "--region: no pixel lies in '1,2,1,4'"},
        {{"s.yarte", "--region", "0,0,16,13"}, "--region: 0,0,16,13 is not within the image of 16x12 pixels"},
        {{"s.yarte", "--size", "65536x1", "-o", "a.dmp"}, "a.dmp: this format cannot hold 65536x1 pixels"},
    };
    for (const Case& c : cases) {
        const auto result = yarte(c.arguments);
        EXPECT_EQ(result.exitCode, 2) << c.message;
        EXPECT_THAT(result.err, StartsWith("yarte: " + c.message));
        EXPECT_EQ(result.out, "");
    }
    EXPECT_THAT(namesIn(folder_), ElementsAre("s.png", "s.yarte"));
    EXPECT_EQ(bytes("s.png"), sphereScene);
    EXPECT_EQ(bytes("s.yarte"), sphereScene);
}

TEST_F(Yarte, ASceneWithErrorsIsExitCode1WithAllOfThemAndNoPicture) {
    write("bad.yarte", std::string(sphereScene) + "sphere 0 0 0 -2\nshere 1 2 3 4\n");
    const auto result = yarte({"bad.yarte"});
    EXPECT_EQ(result.exitCode, 1);
    EXPECT_THAT(result.err,
                AllOf(StartsWith("bad.yarte:7:14: error: "), HasSubstr("\nbad.yarte:8:1: error: ")));
    EXPECT_THAT(result.err, testing::Not(HasSubstr("\x1b"))) << "colours are for terminals";
    EXPECT_THAT(namesIn(folder_), ElementsAre("bad.yarte"));
}

TEST_F(Yarte, AWarningDoesNotStopTheRender) {
    write("dark.yarte", "camera_position 0 0 5\nfocus_point 0 0 0\n");
    const auto result = yarte({"dark.yarte", "--size", "4x4"});
    EXPECT_EQ(result.exitCode, 0);
    EXPECT_THAT(result.err, HasSubstr("warning: "));
    EXPECT_THAT(namesIn(folder_), ElementsAre("dark.png", "dark.yarte"));
}

TEST_F(Yarte, DiagnosticsForMachinesAreOneObjectALine) {
    write("bad.yarte", std::string(sphereScene) + "sphere 0 0 0 -2\n");
    EXPECT_THAT(yarte({"bad.yarte", "--diagnostics=json"}).err,
                AllOf(StartsWith(R"({"severity": "error", "code": )"),
                      HasSubstr(R"("file": "bad.yarte", "line": 7, "column": 14)")));
    EXPECT_EQ(yarte({"none.yarte", "--diagnostics=json"}).err,
              R"({"severity": "error", "code": "yarte.could-not-run", )"
              R"("message": "cannot open none.yarte: no such file or directory", "notes": []})"
              "\n");
}

TEST_F(Yarte, WhatCannotBeReadIsExitCode3) {
    const auto expect = [&](const std::string& scene, const std::string& message) {
        const auto result = yarte({scene});
        EXPECT_EQ(result.exitCode, 3);
        EXPECT_EQ(result.err, message);
    };
    expect("none.yarte", "yarte: cannot open none.yarte: no such file or directory\n");
    expect(".", "yarte: cannot open .: is a directory\n");
    if (geteuid() != 0) { // root may read everything
        write("secret.yarte", sphereScene);
        fs::permissions(folder_ / "secret.yarte", fs::perms::none);
        expect("secret.yarte", "yarte: cannot open secret.yarte: permission denied\n");
    }
}

TEST_F(Yarte, WhatCannotBeWrittenIsExitCode3BeforeAnyRendering) {
    write("s.yarte", sphereScene);
    fs::create_directories(folder_ / "folder.png");
    const auto expect = [&](const std::vector<std::string>& output, const std::string& message) {
        std::vector<std::string> arguments{"s.yarte", "--size", "20000x20000"}; // would take minutes
        arguments.insert(arguments.end(), output.begin(), output.end());
        const auto result = yarte(arguments);
        EXPECT_EQ(result.exitCode, 3);
        EXPECT_EQ(result.err, message);
    };
    expect({"-o", "none/a.png"}, "yarte: cannot write none/a.png: no such folder\n");
    expect({"-o", "a.png", "-o", "s.yarte/a.exr"}, "yarte: cannot write s.yarte/a.exr: no such folder\n");
    expect({"-o", "folder.png"}, "yarte: cannot write folder.png: is a directory\n");
    expect({"--stats", "none/s.json"}, "yarte: cannot write none/s.json: no such folder\n");
    EXPECT_THAT(namesIn(folder_), ElementsAre("folder.png", "s.yarte"));
}

TEST_F(Yarte, AFolderWithoutPermissionIsExitCode3) {
    // Not even root makes files in /proc: there the first sign is the write itself.
    const auto result = yarte({paper, "--size", "8x8", "-o", "/proc/a.png"});
    EXPECT_EQ(result.exitCode, 3);
    EXPECT_THAT(result.err, StartsWith("yarte: cannot write /proc/a.png: "));
    if (geteuid() == 0) return;
    fs::permissions(folder_, fs::perms::owner_read | fs::perms::owner_exec);
    const auto own = yarte({paper, "--size", "8x8", "-o", "a.png"});
    fs::permissions(folder_, fs::perms::owner_all);
    EXPECT_EQ(own.exitCode, 3);
    EXPECT_EQ(own.err, "yarte: cannot write a.png: its folder is not writable\n");
}

TEST_F(Yarte, AFullDiskIsExitCode3AndLeavesTheOtherOutputs) {
    fs::create_symlink("/dev/full", folder_ / "full.pfm");
    const auto result =
        yarte({paper, "--size", "8x8", "-o", "first.png", "-o", "full.pfm", "-o", "last.png"});
    EXPECT_EQ(result.exitCode, 3);
    EXPECT_EQ(result.err, "yarte: cannot write full.pfm: no space left on device\n");
    EXPECT_THAT(namesIn(folder_), ElementsAre("first.png", "full.pfm"));
}

TEST_F(Yarte, AnOutputThatBreaksOffLeavesNoFile) {
    write("a.pfm", "old");
    // A limit on the size of files stands for a disk that fills while the file is written.
    const auto result = run("yarte", {paper, "--size", "100x100", "-o", "a.pfm", "-o", "b.png"}, folder_, {},
                            {.fileSize = 50000});
    EXPECT_EQ(result.exitCode, 3);
    EXPECT_EQ(result.err, "yarte: cannot write a.pfm: file too large\n");
    EXPECT_EQ(bytes("a.pfm"), "old");
    EXPECT_THAT(namesIn(folder_), ElementsAre("a.pfm"));
}

TEST_F(Yarte, AnImageThatDoesNotFitIsRefusedWithTheMemoryItNeeds) {
    const auto result = yarte({paper, "--size", "1000000x1000000"});
    EXPECT_EQ(result.exitCode, 3);
    EXPECT_THAT(result.err,
                MatchesRegex("yarte: image of 1000000x1000000 pixels needs 22351\\.7 GiB, .* GiB\n"));
    write("s.yarte", "image_resolution 1000000 1000000\n" + std::string(sphereScene).substr(23));
    EXPECT_THAT(yarte({"s.yarte"}).err, StartsWith("yarte: image of 1000000x1000000 pixels needs "));
    EXPECT_THAT(namesIn(folder_), ElementsAre("s.yarte"));
}

} // namespace
} // namespace yarte::test
