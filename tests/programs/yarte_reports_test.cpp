// The program `yarte`: what it tells of its progress, its work and its time.
#include "tests/programs/yarte_program.h"

#include "yarte/version.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include <sstream>

namespace yarte::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::MatchesRegex;
using testing::StartsWith;

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
