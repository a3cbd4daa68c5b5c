// An interrupted `yarte` that goes on from its checkpoint: the same bytes, or a refusal that says why.
#include "tests/support/program.h"

#include "yarte/base/file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <thread>

namespace yarte::test {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;
using testing::HasSubstr;
using testing::StartsWith;

constexpr const char* scene =
    "camera_position 0 0 5\nbackground_colour 0.1 0.2 0.3\nfocus_point 0 0 0\nlight_source 5 5 5 1\n"
    "material 0.2 0.2 0.2 0.5 0.5 0.5 0.5 0.5 0.5 20 0.3 0 0\n"
    "sphere 0 0 0 2\nmesh t.pmf 1 1 0 0 0 1 0 0 0 1 0 0 0\n";
constexpr const char* triangle = "3 1\n-1 -1 2\n1 -1 2\n0 1 2\n0 1 2\n";

/// Bytes in the checkpoint for each tile of 32 x 32 pixels.
constexpr std::size_t recordSize = 48 + 32 * 32 * 24;

class YarteCheckpoint : public testing::Test {
protected:
    YarteCheckpoint() {
        writeFile(folder_ / "s.yarte", scene);
        writeFile(folder_ / "t.pmf", triangle);
    }

    static std::vector<std::string> joined(std::vector<std::string> options,
                                           const std::vector<std::string>& more) {
        options.insert(options.end(), more.begin(), more.end());
        return options;
    }
    std::vector<std::string> with(const std::vector<std::string>& more) const {
        return joined({"s.yarte", "--size", "160x120", "-o", "a.pfm"}, more);
    }
    ProgramResult yarte(const std::vector<std::string>& options) const {
        return run("yarte", options, folder_);
    }

    std::string picture(const std::vector<std::string>& options) const {
        const ProgramResult result = yarte(options);
        EXPECT_EQ(result.exitCode, 0) << result.err;
        return readFile(folder_ / "a.pfm");
    }

    std::size_t sizeOfCheckpoint() const {
        std::error_code error;
        const auto size = fs::file_size(folder_ / "c", error);
        return error ? 0 : size;
    }

    const fs::path folder_ = emptyTestFolder();
};

TEST_F(YarteCheckpoint, ARenderKilledAnywhereGoesOnToTheSameBytes) {
    const std::vector<std::string> large{"s.yarte", "--size", "700x500", "--samples", "4", "-o", "a.pfm"};
    const std::string expected = picture(large);
    for (const char* mode : {"--processes", "--threads"})
        for (const int signal : {SIGKILL, SIGINT})
            for (const std::size_t tiles : {0u, 1u, 60u}) {
                fs::remove(folder_ / "c"), fs::remove(folder_ / "a.pfm");
                {
                    Program program("yarte", joined(large, {mode, "2", "--checkpoint", "c"}), folder_);
                    while (!program.hasEnded() && sizeOfCheckpoint() < 1 + tiles * recordSize)
                        std::this_thread::sleep_for(1ms);
                    ::kill(program.id(), signal);
                    EXPECT_NE(program.wait().exitCode, 0) << "it was too fast to be killed";
                }
                EXPECT_FALSE(fs::exists(folder_ / "a.pfm"));
                EXPECT_TRUE(picture(joined(large, {"--checkpoint", "c", "--resume"})) == expected)
                    << mode << " signal " << signal << " after " << tiles << " tiles";
            }
}

TEST_F(YarteCheckpoint, RaysOfAResumedRenderAreThoseOfAWholeOne) {
    const std::string expected = picture(with({"--stats", "whole"}));
    EXPECT_TRUE(picture(with({"--checkpoint", "c"})) == expected);
    // Without its last 7 tiles, and half of another.
    const std::string journal = readFile(folder_ / "c");
    writeFile(folder_ / "c", journal.substr(0, journal.size() - 7 * recordSize - recordSize / 2));
    EXPECT_TRUE(picture(with({"--checkpoint", "c", "--resume", "--stats", "resumed"})) == expected);
    const auto rays = [&](const char* name) {
        const std::string stats = readFile(folder_ / name);
        return stats.substr(stats.find("\"rays\""), stats.find('}') - stats.find("\"rays\""));
    };
    EXPECT_EQ(rays("resumed"), rays("whole"));
    EXPECT_TRUE(picture(with({"--checkpoint", "c", "--resume"})) == expected); // nothing is left to do
}

TEST_F(YarteCheckpoint, WhatHasChangedIsNamed) {
    ASSERT_EQ(yarte(with({"--checkpoint", "c"})).exitCode, 0);
    const auto refusal = [&](const std::vector<std::string>& options) {
        const ProgramResult result = yarte(options);
        EXPECT_EQ(result.exitCode, 1) << result.err;
        return result.err;
    };
    const std::vector<std::string> resume{"--checkpoint", "c", "--resume"};
    EXPECT_THAT(refusal(joined(resume, {"s.yarte", "--size", "161x120"})),
                HasSubstr("c: of another render: the image's size was 160x120, is 161x120"));
    EXPECT_THAT(refusal(with(joined(resume, {"--region", "0,0,50,50"}))),
                HasSubstr("--region was 0,0,160,120, is 0,0,50,50"));
    EXPECT_THAT(refusal(with(joined(resume, {"--samples", "3"}))), HasSubstr("--samples was 1, is 3"));
    EXPECT_THAT(refusal(with(joined(resume, {"--precision", "fast"}))),
                HasSubstr("--precision was double, is fast"));
    EXPECT_THAT(refusal(with(joined(resume, {"--tile", "16"}))), HasSubstr("--tile was 32, is 16"));
    writeFile(folder_ / "t.pmf", "3 1\n-1 -1 2\n1 -1 2\n0 1 2.5\n0 1 2\n");
    EXPECT_THAT(refusal(with(resume)), HasSubstr("of another render: the mesh 't.pmf' was "));
    writeFile(folder_ / "t.pmf", triangle);
    writeFile(folder_ / "s.yarte", std::string(scene) + "\n");
    EXPECT_THAT(refusal(with(resume)), HasSubstr("of another render: the scene's text was "));
    writeFile(folder_ / "s.yarte", scene);
    EXPECT_EQ(yarte(with(joined(resume, {"--threads", "3", "-o", "b.png"}))).exitCode, 0); // no matter
}

TEST_F(YarteCheckpoint, DamageIsToldAndMended) {
    const std::string expected = picture(with({"--checkpoint", "c"}));
    std::string journal = readFile(folder_ / "c");
    journal[journal.size() - 1000] ^= 1;
    writeFile(folder_ / "c", journal);
    const ProgramResult result = yarte(with({"--checkpoint", "c", "--resume"}));
    EXPECT_EQ(result.exitCode, 0);
    EXPECT_THAT(result.err, HasSubstr("warning: c: 1 of its tiles were damaged, and are rendered again"));
    EXPECT_TRUE(readFile(folder_ / "a.pfm") == expected);
    journal[30] ^= 1;
    writeFile(folder_ / "c", journal);
    const ProgramResult refused = yarte(with({"--checkpoint", "c", "--resume"}));
    EXPECT_EQ(refused.exitCode, 1);
    EXPECT_THAT(refused.err, HasSubstr("c: no checkpoint, or its head is damaged"));
}

TEST_F(YarteCheckpoint, OfAWholeRenderProgressTellsTheEnd) {
    picture(with({"--checkpoint", "c"}));
    for (const char* processes : {"0", "2"}) {
        const ProgramResult result =
            yarte(with({"--checkpoint", "c", "--resume", "--progress", "json", "--processes", processes}));
        EXPECT_EQ(result.exitCode, 0);
        EXPECT_THAT(result.err, HasSubstr("{\"done\": 20, \"total\": 20, "));
    }
}

TEST_F(YarteCheckpoint, ThePartialPictureCanBeSeen) {
    const std::string expected = picture(with({"--checkpoint", "c"}));
    const std::string journal = readFile(folder_ / "c");
    EXPECT_TRUE(picture(with({"--checkpoint", "c", "--partial"})) == expected);
    writeFile(folder_ / "c", journal.substr(0, journal.size() - recordSize));
    const std::string partial = picture(with({"--checkpoint", "c", "--partial"}));
    EXPECT_TRUE(partial != expected);
    EXPECT_EQ(partial.size(), expected.size());
    EXPECT_EQ(readFile(folder_ / "c").size(), journal.size() - recordSize); // as it was
}

TEST_F(YarteCheckpoint, WrongUsage) {
    ASSERT_EQ(yarte(with({"--checkpoint", "c"})).exitCode, 0);
    const std::string before = readFile(folder_ / "c");
    const ProgramResult again = yarte(with({"--checkpoint", "c"}));
    EXPECT_EQ(again.exitCode, 2);
    EXPECT_THAT(again.err, StartsWith("yarte: c: there is a checkpoint already; --resume goes on from it"));
    EXPECT_EQ(yarte(with({"--resume"})).exitCode, 2);
    EXPECT_EQ(yarte(with({"--partial"})).exitCode, 2);
    EXPECT_EQ(yarte(with({"--checkpoint", "s.yarte"})).exitCode, 2);
    EXPECT_EQ(yarte(with({"--checkpoint", "s.yarte", "--resume"})).exitCode, 1);
    EXPECT_EQ(yarte(with({"--checkpoint", "no/such/folder"})).exitCode, 3);
    EXPECT_EQ(yarte(with({"--checkpoint", "none", "--partial"})).exitCode, 3);
    EXPECT_EQ(readFile(folder_ / "c"), before);
    EXPECT_EQ(readFile(folder_ / "s.yarte"), scene);
}

} // namespace
} // namespace yarte::test
