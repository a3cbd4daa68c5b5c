// `yarte-validate speed` as users run it, with the programs that were built beside it.
#include "tests/support/povray.h"
#include "tests/validate/command_line.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <cstdlib>

namespace yarte::validate {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::StartsWith;
using namespace test;

class SpeedCommand : public CommandLine {
protected:
    void SetUp() override {
        CommandLine::SetUp();
        writeFile(folder_ / "scene.yarte",
                  "image_resolution 24 18\ncamera_position 0 1 6\nfocus_point 0 0 0\n"
                  "camera_apertures 25 19\nbackground_colour 0.2 0.3 0.4\n"
                  "light_source 5 9 6 1\nmax_recurse_level 2\n"
                  "material 0.1 0 0 0.7 0.1 0 0.3 0.3 0.3 80 0.2 0 0\n"
                  "sphere 0.13 0.21 0 1\nsphere 1.6 0.1 -0.7 0.6\n"
                  "material 0 0.1 0 0 0.6 0.1 0 0 0 1 0 0 0\n"
                  "polygon 4 -5.1 -1.2 4 4.9 -1.2 4 4.7 -1.2 -5 -5 -1.2 -5\n");
    }
    int speed(const std::vector<std::string>& more, const std::vector<std::string>& scenes = {"scene.yarte"},
              const std::vector<std::string>& environment = {}) {
        std::vector<std::string> arguments{"speed"};
        arguments.insert(arguments.end(), {"-o", "out", "--runs", "1"});
        arguments.insert(arguments.end(), more.begin(), more.end());
        arguments.insert(arguments.end(), scenes.begin(), scenes.end());
        return validate(arguments, environment);
    }
    json report() const { return json::parse(readFile(folder_ / "out/speed.json")); }
    std::string schemaErrors() const {
        const std::filesystem::path root = YARTE_SOURCE_DIR;
        return run({{"/bin/sh", "-c", "python3 \"$@\" >&2", "sh", root / "tests/validate/check_schema.py",
                     root / "validate/speed.schema.json", "out/speed.json"},
                    folder_,
                    {"PATH=/usr/bin:/bin"},
                    60,
                    0,
                    0},
                   stop_)
            .errorText;
    }
};

/// What must hold of any program's curve. POV-Ray tells milliseconds, and traces this scene in less than one.
void expectFalling(const json& curve) {
    double last = 1;
    for (const json& point : curve["points"]) {
        EXPECT_LT(point["error"]["rmse"], last) << curve["name"] << ' ' << point["samples"];
        EXPECT_GE(point["error"]["max_abs"], point["error"]["rmse"]);
        if (curve["name"] == "POV-Ray")
            EXPECT_GE(point["trace_s"]["median"], 0);
        else
            EXPECT_GT(point["trace_s"]["median"], 0);
        last = point["error"]["rmse"];
    }
    EXPECT_GT(last, 0);
}

TEST_F(SpeedCommand, MoreSamplesAreLessErrorAndMoreTrianglesToo) {
    ASSERT_EQ(speed({"--samples", "4,1,2", "--reference", "8", "--rays", "200", "--chord-errors",
                     "0.1,0.01,0.001"}),
              0)
        << output_ << errors_;
    EXPECT_THAT(output_, StartsWith("scene  24x18, against 8x8 samples\n"));
    EXPECT_THAT(output_, HasSubstr("POV-Ray is left out: povray not found")); // PATH leads nowhere
    if (std::system("command -v python3 > /dev/null") == 0) {
        EXPECT_EQ(schemaErrors(), "");
    }

    const json scene = report()["cases"][0];
    EXPECT_EQ(scene["message"], "");
    ASSERT_EQ(scene["curves"].size(), 2u);
    for (const json& curve : scene["curves"]) {
        ASSERT_EQ(curve["points"].size(), 3u);
        EXPECT_EQ(curve["points"][2]["samples"], 4);
        expectFalling(curve);
    }
    const json fast = scene["curves"][1]["points"];
    for (const json& point : fast) {
        EXPECT_LT(point["from_double"]["rmse"], 1e-3);
        EXPECT_LT(point["from_double"]["rmse"], point["error"]["rmse"]);
    }
    EXPECT_TRUE(scene["curves"][0]["points"][0]["from_double"].is_null());

    // A double's rounding, and a float's.
    const json rays = scene["rays"];
    EXPECT_EQ(rays["width"], 16);
    EXPECT_EQ(rays["height"], 12);
    ASSERT_EQ(rays["programs"].size(), 2u);
    EXPECT_LT(rays["programs"][0]["distance"]["rms"], 1e-14);
    EXPECT_LT(rays["programs"][0]["normal"]["rms"], 1e-13);
    EXPECT_GT(rays["programs"][1]["distance"]["rms"], 1e-9);
    EXPECT_LT(rays["programs"][1]["distance"]["rms"], 1e-5);
    for (const json& program : rays["programs"]) {
        EXPECT_LE(program["otherwise"], 2);
        EXPECT_GT(program["compared"], 50);
    }

    const json triangles = scene["tessellation"];
    EXPECT_EQ(triangles["largest_radius"], 1);
    ASSERT_EQ(triangles["points"].size(), 3u);
    double error = 1, number = 0;
    for (const json& point : triangles["points"]) {
        EXPECT_LE(point["deviation"], point["chord_error"]);
        EXPECT_GT(point["triangles"], number);
        EXPECT_LT(point["error"]["rmse"], error);
        error = point["error"]["rmse"], number = point["triangles"];
    }
    ASSERT_EQ(scene["plots"].size(), 6u);
    for (const json& plot : scene["plots"])
        EXPECT_THAT(readFile(folder_ / "out" / plot["file"]), HasSubstr("</svg>"));
    EXPECT_THAT(readFile(folder_ / "out/index.html"), HasSubstr("</html>"));
}

TEST_F(SpeedCommand, EveryKindOfShapeIsMetWhereItIsInTruth) {
    std::vector<std::string> scenes;
    for (const std::string name :
         {"turned", "cylinders", "planes", "smooth_mesh", "mesh", "concave", "two_sided"})
        scenes.push_back(YARTE_SOURCE_DIR "/scenes/" + name + "/" + name + ".yarte");
    ASSERT_EQ(
        speed({"--samples", "1", "--reference", "2", "--size", "32x24", "--no-tessellation", "--no-povray"},
              scenes),
        0)
        << output_ << errors_;
    const json cases = report()["cases"];
    for (const json& scene : cases) {
        const json rays = scene["rays"]["programs"];
        EXPECT_EQ(rays[0]["otherwise"], 0) << scene["name"];
        EXPECT_GT(rays[0]["compared"], 100) << scene["name"];
        EXPECT_LT(rays[0]["distance"]["rms"], 1e-13) << scene["name"];
        EXPECT_LT(rays[0]["normal"]["rms"], 1e-13) << scene["name"];
        EXPECT_LE(rays[1]["otherwise"], 2) << scene["name"];
        EXPECT_LT(rays[1]["distance"]["rms"], 1e-4) << scene["name"];
    }
}

TEST_F(SpeedCommand, PovrayHasTheSameErrors) {
    if (!yarte::test::hasPovray()) GTEST_SKIP() << "skipped: povray not found";
    ASSERT_EQ(speed({"--samples", "1,3", "--reference", "8", "--rays", "100", "--no-tessellation"},
                    {"scene.yarte"}, {std::string("PATH=") + std::getenv("PATH")}),
              0)
        << output_ << errors_;
    const json scene = report()["cases"][0];
    ASSERT_EQ(scene["curves"].size(), 3u) << scene["note"];
    for (int n = 0; n < 2; ++n) { // the same rays, the same estimator: only 16 bits are between them
        const double ours = scene["curves"][0]["points"][n]["error"]["rmse"],
                     theirs = scene["curves"][2]["points"][n]["error"]["rmse"];
        EXPECT_NEAR(ours, theirs, 1e-5);
    }
    expectFalling(scene["curves"][2]);
    const json rays = scene["rays"];
    ASSERT_EQ(rays["programs"].size(), 3u) << rays["note"];
    EXPECT_EQ(rays["programs"][2]["name"], "POV-Ray");
    EXPECT_LT(rays["programs"][2]["distance"]["rms"], 1e-13);
    EXPECT_LT(rays["programs"][2]["normal"]["rms"], 1e-12);
    EXPECT_EQ(rays["programs"][2]["otherwise"], 0);
}

TEST_F(SpeedCommand, WhatIsLeftOutIsSaid) {
    ASSERT_EQ(speed({"--reference", "2", "--rays", "0", "--no-tessellation", "--no-povray"}), 0) << errors_;
    const json scene = report()["cases"][0];
    EXPECT_EQ(scene["note"], "POV-Ray is left out (--no-povray)");
    EXPECT_EQ(scene["rays"]["note"], "Left out (--rays 0)");
    EXPECT_EQ(scene["tessellation"]["note"], "Left out (--no-tessellation)");
    ASSERT_EQ(scene["curves"].size(), 2u);
    EXPECT_EQ(scene["curves"][0]["points"].size(), 1u) << "the default's samples below the reference's";
    EXPECT_EQ(scene["plots"].size(), 2u);
}

TEST_F(SpeedCommand, FloatThatIsTooCoarseIsSaid) {
    std::string text = readFile(folder_ / "scene.yarte");
    text.replace(text.find("camera_apertures 25 19"), 22, "camera_apertures 0.001 0.001");
    writeFile(folder_ / "narrow.yarte", text);
    ASSERT_EQ(
        speed({"--reference", "2", "--rays", "0", "--no-tessellation", "--no-povray"}, {"narrow.yarte"}), 0)
        << errors_;
    EXPECT_EQ(report()["cases"][0]["note"],
              "POV-Ray is left out (--no-povray). YARTE fast computed in double: "
              "float is too coarse for this scene");
}

TEST_F(SpeedCommand, ASceneThatCannotBeMeasuredDoesNotStopTheOthers) {
    writeFile(folder_ / "bad.yarte", "sphere 0 0 0 -1\n");
    EXPECT_EQ(speed({"--samples", "1", "--rays", "0", "--no-tessellation"}, {"bad.yarte", "scene.yarte"}), 3);
    EXPECT_THAT(output_, StartsWith("bad  yarte: exit code 1\n"));
    EXPECT_THAT(output_, HasSubstr("scene.radius-not-positive"));
    EXPECT_THAT(output_, HasSubstr("\nscene  24x18"));
    EXPECT_EQ(report()["cases"][1]["curves"].size(), 2u);
    EXPECT_EQ(speed({"--samples", "1", "--povray", "./nowhere"}), 3) << "it was asked for";
    EXPECT_THAT(output_, HasSubstr("povray: not started"));
}

TEST_F(SpeedCommand, WrongUsage) {
    const auto refused = [&](const std::vector<std::string>& arguments, const char* why) {
        EXPECT_EQ(speed(arguments), 2) << why;
        EXPECT_THAT(errors_, HasSubstr(why));
    };
    refused({"--samples", "1,8", "--reference", "8"}, "--samples: must be below those of the reference, 8");
    refused({"--samples", "0"}, "--samples");
    refused({"--samples", "two"}, "--samples");
    refused({"--runs", "0"}, "--runs");
    refused({"--chord-errors", "2"}, "--chord-errors");
    refused({"--rays", "-1"}, "--rays");
    refused({"--size", "8"}, "--size");
    refused({"--processes", "0"}, "--processes: must be at least 1");
    refused({"--jobs", "2"}, "--jobs: is for comparisons, not for speed");
    refused({"--no-povray", "--povray", "povray"}, "--no-povray");
    EXPECT_EQ(validate({"speed", "-o", "out"}), 2);
    EXPECT_THAT(errors_, HasSubstr("SCENE is required"));
    EXPECT_EQ(validate({"speed", "scene.yarte"}), 2);
    EXPECT_FALSE(wrote("speed.json"));
    EXPECT_EQ(validate({"speed", "--help"}), 0);
    EXPECT_THAT(output_, HasSubstr("--chord-errors"));
}

TEST_F(SpeedCommand, AFolderThatCannotBeWritten) {
    writeFile(folder_ / "out", "a file");
    EXPECT_EQ(speed({"--samples", "1"}), 3);
    EXPECT_THAT(errors_, HasSubstr("out"));
}

} // namespace
} // namespace yarte::validate
