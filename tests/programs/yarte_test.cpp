// The program `yarte` as users run it: its pictures.
#include "tests/programs/yarte_program.h"

#include <gmock/gmock.h>

#include <sstream>

namespace yarte::test {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

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

} // namespace
} // namespace yarte::test
