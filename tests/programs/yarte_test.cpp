// The program `yarte` as users run it: pictures, options and exit codes. Signals are in
// yarte_signals_test.cpp.
#include "tests/support/program.h"

#include "yarte/version.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <sstream>

#include <unistd.h>

namespace yarte::test {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::MatchesRegex;
using testing::StartsWith;

const std::string paper = std::string(YARTE_SOURCE_DIR) + "/scenes/paper/paper.yarte";

constexpr const char* sphereScene = "image_resolution 16 12\n"
                                    "camera_position 0 0 5\n"
                                    "focus_point 0 0 0\n"
                                    "light_source 5 5 5 1\n"
                                    "material 0.2 0.2 0.2 0.5 0.5 0.5 0.5 0.5 0.5 20 0 0 0\n"
                                    "sphere 0 0 0 2\n";

std::string read(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    EXPECT_TRUE(in) << file;
    return {std::istreambuf_iterator<char>(in), {}};
}

class Yarte : public testing::Test {
protected:
    ProgramResult yarte(const std::vector<std::string>& arguments,
                        const std::vector<std::string>& environment = {}) const {
        return run("yarte", arguments, folder_, environment);
    }

    /// yarte, which must succeed in silence.
    void render(const std::vector<std::string>& arguments) const {
        const ProgramResult result = yarte(arguments);
        ASSERT_EQ(result.exitCode, 0) << result.err;
        EXPECT_EQ(result.out + result.err, "");
    }

    void write(const std::string& name, const std::string& text) const {
        std::ofstream(folder_ / name) << text;
    }
    std::string bytes(const std::string& name) const { return read(folder_ / name); }

    const fs::path folder_ = emptyTestFolder();
};

TEST_F(Yarte, WritesTheSameBytesInEveryModeAndForAnyTileSize) {
    const auto picture = [&](std::vector<std::string> options) {
        options.insert(options.end(),
                       {paper, "--size", "61x47", "-o", "a.pfm", "-o", "a.png", "--depth", "16"});
        render(options);
        return bytes("a.pfm") + bytes("a.png");
    };
    const std::string reference = picture({"--processes", "0"});
    EXPECT_EQ(reference.size(), bytes("a.png").size() + 14 + 61 * 47 * 12);
    EXPECT_EQ(picture({}), reference);
    for (const char* processes : {"0", "1", "2", "7", "64"})
        for (const char* side : {"1", "7", "32", "1000"})
            EXPECT_EQ(picture({"--processes", processes, "--tile", side}), reference)
                << processes << ' ' << side;
    for (const char* threads : {"1", "2", "3", "4", "5"})
        for (const char* side : {"7", "1000"})
            EXPECT_EQ(picture({"--threads", threads, "--tile", side}), reference) << threads << ' ' << side;
}

TEST_F(Yarte, InFloatTheBytesAreTheSameInEveryModeAndTheAovThoseOfDouble) {
    const auto files = [&](std::vector<std::string> options) {
        options.insert(options.end(), {paper, "--size", "61x47", "-o", "a.pfm", "--aov", "a.exr"});
        render(options);
        return std::pair(bytes("a.pfm"), bytes("a.exr"));
    };
    const auto [exact, exactAov] = files({"--precision", "double", "--stats", "s.json"});
    EXPECT_THAT(bytes("s.json"), HasSubstr("\"precision\": \"double\""));
    const auto [fast, aov] = files({"--precision", "fast", "--processes", "0", "--stats", "s.json"});
    EXPECT_THAT(bytes("s.json"), HasSubstr("\"precision\": \"fast\""));
    EXPECT_NE(fast, exact);
    EXPECT_TRUE(aov == exactAov);
    for (const char* workers : {"--processes", "--threads"})
        for (const char* side : {"7", "1000"})
            EXPECT_EQ(files({"--precision", "fast", workers, "3", "--tile", side}).first, fast)
                << workers << ' ' << side;
}

TEST_F(Yarte, TellsWhatRaysMeetInEitherPrecision) {
    write("s.yarte", sphereScene);
    for (const char* samples : {"1", "2"}) {
        render({"s.yarte", "-o", "a.png", "--size", "3x1", "--hits", "a.csv", "--samples", samples});
        EXPECT_EQ(bytes("a.csv"), "x,y,body,distance,normal_x,normal_y,normal_z\n"
                                  "0,0,-1,0,0,0,0\n1,0,0,3,0,0,1\n2,0,-1,0,0,0,0\n");
    }
    const auto distance = [&](const char* precision) {
        render(
            {"s.yarte", "-o", "a.png", "--region", "5,5,6,6", "--hits", "a.csv", "--precision", precision});
        const std::string text = bytes("a.csv");
        EXPECT_THAT(text, HasSubstr("\n5,5,0,3."));
        return std::stod(text.substr(text.find("\n5,5,0,") + 7));
    };
    const double exact = distance("double"), fast = distance("fast");
    EXPECT_NE(exact, fast);
    EXPECT_NEAR(exact, fast, 1e-5);
    EXPECT_EQ(yarte({"s.yarte", "--hits", "s.yarte"}).exitCode, 2);
    EXPECT_EQ(yarte({"s.yarte", "--hits", "nowhere/a.csv"}).exitCode, 3);
    EXPECT_EQ(bytes("s.yarte"), sphereScene);
}

TEST_F(Yarte, WhatFloatCannotHoldIsTracedInDoubleWithAWarning) {
    write("s.yarte", std::string(sphereScene) + "camera_apertures 0.001 0.001\n");
    render({"s.yarte", "-o", "exact.pfm"});
    const auto result = yarte({"s.yarte", "-o", "fast.pfm", "--precision", "fast", "--stats", "s.json"});
    EXPECT_EQ(result.exitCode, 0);
    EXPECT_THAT(result.err, AllOf(StartsWith("warning: "), HasSubstr("[yarte.precision]")));
    EXPECT_THAT(bytes("s.json"), HasSubstr("\"precision\": \"double\""));
    EXPECT_EQ(bytes("fast.pfm"), bytes("exact.pfm"));
}

TEST_F(Yarte, ARegionHasThePixelsOfTheWholePicture) {
    render({paper, "--size", "61x47", "-o", "whole.ppm"});
    const std::string whole = bytes("whole.ppm").substr(sizeof "P6\n61 47\n255\n" - 1);
    struct Region {
        std::size_t x0, y0, x1, y1;
    };
    for (const Region r : {Region{0, 0, 61, 47}, {60, 46, 61, 47}, {13, 5, 50, 40}})
        for (const char* workers : {"--processes", "--threads"}) {
            std::ostringstream region, expected;
            region << r.x0 << ',' << r.y0 << ',' << r.x1 << ',' << r.y1;
            expected << "P6\n" << r.x1 - r.x0 << ' ' << r.y1 - r.y0 << "\n255\n";
            for (std::size_t y = r.y0; y < r.y1; ++y)
                expected << whole.substr(3 * (61 * y + r.x0), 3 * (r.x1 - r.x0));
            render({paper, "--size", "61x47", "--region", region.str(), workers, "3", "--tile", "5", "-o",
                    "r.ppm"});
            EXPECT_EQ(bytes("r.ppm"), expected.str()) << region.str();
        }
}

TEST_F(Yarte, SamplesAreTheSameInEveryModeAndSmoothEdges) {
    const auto picture = [&](std::vector<std::string> options) {
        options.insert(options.end(), {paper, "--size", "40x30", "-o", "a.pfm", "--aov", "a.exr"});
        render(options);
        return bytes("a.pfm");
    };
    const std::string one = picture({}), aov = bytes("a.exr");
    EXPECT_EQ(picture({"--samples", "1"}), one);
    const std::string nine = picture({"--samples", "3", "--processes", "0"});
    EXPECT_NE(nine, one);
    EXPECT_EQ(bytes("a.exr"), aov); // of the ray through the centre
    EXPECT_EQ(picture({"--samples", "3", "--processes", "3", "--tile", "7"}), nine);
    EXPECT_EQ(picture({"--samples", "3", "--threads", "2"}), nine);
}

TEST_F(Yarte, AMeshMayBeGltf) {
    // One triangle (-1, -1, 0), (1, -1, 0), (0, 1, 0), moved up by its node and back down by the scene.
    write("m.gltf", R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],
        "nodes":[{"mesh":0,"translation":[0,8,0]}],"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],
        "accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[-1,-1,0],"max":[1,1,0]}],
        "bufferViews":[{"buffer":0,"byteLength":36}],"buffers":[{"byteLength":36,"uri":
        "data:application/octet-stream;base64,AACAvwAAgL8AAAAAAACAPwAAgL8AAAAAAAAAAAAAgD8AAAAA"}]})");
    write("m.pmf", "3 1\n-1 -1 0\n1 -1 0\n0 1 0\n0 1 2\n");
    std::string scene = sphereScene;
    scene.erase(scene.rfind("sphere"));
    write("gltf.yarte", scene + "mesh m.gltf 2 1 0 0 0 1 0 0 0 1 0 -16 0\n");
    write("pmf.yarte", scene + "mesh m.pmf 2 1 0 0 0 1 0 0 0 1 0 0 0\n");
    write("none.yarte", scene + "sphere 0 0 99 1\n");
    for (const char* name : {"gltf", "pmf", "none"})
        render({std::string(name) + ".yarte", "-o", std::string(name) + ".pfm", "--size", "40x40"});
    EXPECT_EQ(bytes("gltf.pfm"), bytes("pmf.pfm"));
    EXPECT_NE(bytes("gltf.pfm"), bytes("none.pfm"));

    write("m.gltf", R"({"asset":{"version":"2.0"},"nodes":[{"mesh":7}]})");
    const auto result = yarte({"gltf.yarte"});
    EXPECT_EQ(result.exitCode, 1);
    EXPECT_THAT(result.err, AllOf(HasSubstr("m.gltf"), HasSubstr("/nodes/0"), HasSubstr("[gltf.")));
}

TEST_F(Yarte, TheAovIsTheSameInEveryMode) {
    const auto aov = [&](std::vector<std::string> options) {
        options.insert(options.end(), {paper, "--size", "31x23", "-o", "a.png", "--aov", "a.exr"});
        render(options);
        return bytes("a.exr");
    };
    const std::string reference = aov({"--processes", "0"});
    for (const char* channel : {"body.id", "line", "depth.Z", "N.X", "shadow.lights", "reflected.id",
                                "transmitted.id", "visit0.weight.R", "light0.arriving.R", "yarte.scene"})
        EXPECT_TRUE(reference.find(std::string(channel) + '\0') != std::string::npos) << channel;
    EXPECT_TRUE(reference.find(R"({"bodies":[{"kind":"sphere","line":18,)") != std::string::npos);
    EXPECT_TRUE(aov({"--processes", "3", "--tile", "5"}) == reference);
    EXPECT_TRUE(aov({"--threads", "2"}) == reference);
    EXPECT_FALSE(aov({"--region", "3,4,20,20"}) == reference);
}

TEST_F(Yarte, WritesThePictureBesideNothingElseIntoTheWorkingDirectory) {
    render({paper, "--size", "8x8"});
    EXPECT_THAT(namesIn(folder_), ElementsAre("paper.png"));
}

TEST_F(Yarte, TakesTheSizeFromTheSceneUnlessTold) {
    write("s.yarte", sphereScene);
    render({"s.yarte", "-o", "a.ppm"});
    EXPECT_THAT(bytes("a.ppm"), StartsWith("P6\n16 12\n255\n"));
    render({"s.yarte", "-o", "a.ppm", "--size", "9x5"});
    EXPECT_THAT(bytes("a.ppm"), StartsWith("P6\n9 5\n255\n"));
}

TEST_F(Yarte, EncodingOptionsReachTheFilesTheyAreFor) {
    const auto all = [&](std::vector<std::string> options) {
        options.insert(options.end(), {paper, "--size", "20x10", "-o", "a.png", "-o", "a.ppm", "-o", "a.pfm",
                                       "-o", "a.exr", "-o", "a.dmp"});
        render(options);
        return std::vector{bytes("a.png"), bytes("a.ppm"), bytes("a.pfm"), bytes("a.exr"), bytes("a.dmp")};
    };
    const auto changed = [&, plain = all({})](const std::vector<std::string>& options) {
        const auto files = all(options);
        std::string which;
        for (std::size_t i = 0; i < files.size(); ++i)
            if (files[i] != plain[i])
                which +=
                    std::string(which.empty() ? "" : " ") + std::vector{"png", "ppm", "pfm", "exr", "dmp"}[i];
        return which;
    };
    EXPECT_EQ(changed({}), "");
    EXPECT_EQ(changed({"--depth", "16"}), "png ppm");
    EXPECT_EQ(changed({"--linear"}), "png ppm");
    EXPECT_EQ(changed({"--half"}), "exr");
    EXPECT_EQ(changed({"--big-endian"}), "dmp");
}

TEST_F(Yarte, MeshesMayLieInAllowedFoldersOnly) {
    fs::create_directories(folder_ / "scene");
    fs::create_directories(folder_ / "meshes");
    write("meshes/m.pmf", "3 1\n0 0 0\n1 0 0\n0 1 0\n0 1 2\n");
    write("scene/s.yarte", std::string(sphereScene) + "mesh ../meshes/m.pmf 1 1 0 0 0 1 0 0 0 1 0 0 0\n");
    const auto refused = yarte({"scene/s.yarte", "-o", "a.png"});
    EXPECT_EQ(refused.exitCode, 1);
    EXPECT_THAT(refused.err, AllOf(StartsWith("scene/s.yarte:7:"), HasSubstr("../meshes/m.pmf")));
    render({"scene/s.yarte", "-o", "a.png", "--allow-path", "meshes"});
}

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

TEST_F(Yarte, ProgressIsSilentUnlessAskedFor) {
    EXPECT_EQ(yarte({paper, "--size", "16x16"}).err, "") << "no terminal here";
    EXPECT_EQ(yarte({paper, "--size", "16x16", "--progress", "none"}).err, "");
    const auto bar = yarte({paper, "--size", "16x16", "--progress", "bar"}).err;
    EXPECT_THAT(bar, HasSubstr("\r[####################] 100 %"));
    EXPECT_THAT(bar, testing::EndsWith("\r\x1b[K")) << "the bar is wiped away";
}

TEST_F(Yarte, ProgressForMachinesEndsWithTheTotal) {
    for (const char* mode : {"--processes=0", "--processes=2", "--threads=2"}) {
        std::istringstream lines(
            yarte({paper, "--size", "64x64", "--tile", "32", "--progress", "json", mode}).err);
        std::string line, last;
        while (std::getline(lines, line)) {
            EXPECT_THAT(
                line,
                MatchesRegex(
                    R"(\{"done": [0-9]+, "total": 4, "elapsed_s": [0-9.]+, "eta_s": ([0-9.]+|null)\})"));
            last = line;
        }
        EXPECT_THAT(
            last, AllOf(StartsWith(R"({"done": 4, "total": 4, )"), testing::EndsWith(R"("eta_s": 0.000})")));
    }
}

TEST_F(Yarte, StatsHoldEveryKeyAndTheSameRaysInEveryMode) {
    std::vector<std::string> rays;
    struct Mode {
        std::string option, name, workers;
    };
    for (const Mode& mode : {Mode{"--processes=0", "serial", "0"},
                             {"--processes=3", "processes", "3"},
                             {"--threads=2", "threads", "2"}}) {
        render({paper, "--size", "64x48", "--region", "0,0,64,40", "--tile", "16", "--stats", "s.json",
                mode.option});
        const std::string json = bytes("s.json");
        EXPECT_THAT(json,
                    StartsWith("{\n  \"version\": \"" + std::string(yarte::version) + "\",\n  \"scene\": \"" +
                               paper + "\",\n  \"width\": 64,\n  \"height\": 40,\n  \"mode\": \"" +
                               mode.name + "\",\n  \"workers\": " + mode.workers +
                               ",\n  \"precision\": \"double\",\n  \"parse_s\": "));
        for (const char* key : {"build_s", "trace_s", "write_s", "wall_s", "peak_rss_bytes"})
            EXPECT_THAT(json, testing::ContainsRegex("  \"" + std::string(key) + "\": [0-9.]+,\n"));
        EXPECT_THAT(json, HasSubstr("  \"profile\": {"));
        rays.push_back(json.substr(json.find("  \"rays\"")));
    }
    EXPECT_THAT(rays[0],
                MatchesRegex("  \"rays\": \\{\"camera\": 2560, \"shadow\": [0-9]+, \"reflected\": [0-9]+, "
                             "\"transmitted\": [0-9]+\\}\n\\}\n"));
    EXPECT_EQ(rays[1], rays[0]);
    EXPECT_EQ(rays[2], rays[0]);
}

TEST_F(Yarte, TheProfileSharesOutTheTimeAndChangesNoPixel) {
    render({paper, "--size", "480x360", "-o", "plain.pfm"});
    for (const char* mode : {"--processes=0", "--processes=2", "--threads=2"}) {
        render({paper, "--size", "480x360", "-o", "a.pfm", "--stats", "s.json", mode});
        EXPECT_EQ(bytes("a.pfm"), bytes("plain.pfm")) << mode;
        const nlohmann::json stats = nlohmann::json::parse(bytes("s.json")), profile = stats.at("profile");
        EXPECT_EQ(profile.at("build_s"), stats.at("build_s"));
        EXPECT_EQ(profile.at("write_s"), stats.at("write_s"));
        double sum = 0;
        for (const char* phase : {"camera_s", "shadow_s", "secondary_s", "shade_s"}) {
            EXPECT_GT(profile.at(phase), 0) << mode << ' ' << phase;
            sum += profile.at(phase).get<double>();
        }
        // The rest is the engine's: starting workers, dealing tiles, gathering pixels, waiting for the last.
        const double rounding = 5e-6;
        EXPECT_LE(sum,
                  stats.at("trace_s").get<double>() * std::max(1, stats.at("workers").get<int>()) + rounding);
        for (const char* kind : {"camera", "shadow", "secondary"})
            EXPECT_GT(profile.at("per_million_rays_s").at(kind), 0) << mode << ' ' << kind;
    }
}

TEST_F(Yarte, WhatTheProfileDoesNotKnowIsNull) {
    write("s.yarte", sphereScene);
    const auto profile = [&](const char* size) {
        render({"s.yarte", "--size", size, "--stats", "s.json", "--processes", "1"});
        return nlohmann::json::parse(bytes("s.json")).at("profile");
    };
    const nlohmann::json known = profile("640x640"), unknown = profile("16x16");
    EXPECT_TRUE(known.at("shadow_s").is_number());
    EXPECT_EQ(known.at("secondary_s"), 0);
    EXPECT_TRUE(known.at("per_million_rays_s").at("secondary").is_null()) << "there is no such ray";
    EXPECT_TRUE(unknown.at("camera_s").is_null()) << "nothing was sampled";
    EXPECT_TRUE(unknown.at("build_s").is_number());
}

} // namespace
} // namespace yarte::test
