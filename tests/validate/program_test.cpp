#include "validate/program.h"

#include "tests/validate/support.h"

#include <cerrno>
#include <chrono>
#include <csignal>
#include <gmock/gmock.h>
#include <thread>

namespace yarte::validate {
namespace {

using test::scratchFolder;
using testing::HasSubstr;

class Program : public testing::Test {
protected:
    ProgramResult shell(const std::string& script) {
        program_.command = {"/bin/sh", "-c", script};
        return run(program_, stop_);
    }
    /// True soon after the process named in `file` has gone.
    bool gone(const std::string& file) const {
        const int pid = std::stoi(readFile(program_.directory / file));
        for (int i = 0; i < 200; ++i) {
            if (::kill(pid, 0) != 0 && errno == ESRCH) return true;
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        }
        return false;
    }

    StopSignal stop_;
    ProgramRun program_{{}, scratchFolder(), {"PATH=/usr/bin:/bin", "GIVEN=yes"}, 60, 0, 0};
};

TEST_F(Program, ExitCodesAndErrorText) {
    const ProgramResult good = shell("echo out; echo err >&2");
    EXPECT_TRUE(good.succeeded());
    EXPECT_EQ(good.errorText, "err\n");
    const ProgramResult bad = shell("exit 7");
    EXPECT_FALSE(bad.succeeded());
    EXPECT_EQ(bad.exitCode, 7);
}

TEST_F(Program, SeesOnlyItsEnvironmentAndFolderAndNoInput) {
    ::setenv("YARTE_SECRET", "x", 1);
    EXPECT_EQ(shell("env | grep -v ^PWD= | grep -v ^_= | sort >&2").errorText,
              "GIVEN=yes\nPATH=/usr/bin:/bin\n");
    EXPECT_EQ(shell("pwd >&2").errorText, program_.directory.string() + "\n");
    EXPECT_EQ(shell("wc -c >&2").errorText, "0\n");
}

TEST_F(Program, ArgumentsAreNotReadByAShell) {
    program_.command = {"/bin/sh", "-c", "echo \"$1\" >&2", "sh", "$(id) `id` '; a b"};
    EXPECT_EQ(run(program_, stop_).errorText, "$(id) `id` '; a b\n");
}

TEST_F(Program, SignalsAreNotExitCodes) {
    const ProgramResult result = shell("kill -SEGV $$");
    EXPECT_EQ(result.signal, SIGSEGV);
    EXPECT_FALSE(result.succeeded());
}

TEST_F(Program, WhatCannotBeStartedIsSaid) {
    program_.command = {"/does/not/exist"};
    EXPECT_EQ(run(program_, stop_).startError, "No such file or directory");
    program_.command = {program_.directory.string()};
    EXPECT_EQ(run(program_, stop_).startError, "Permission denied");
}

TEST_F(Program, TheTimeLimitEndsTheWholeGroup) {
    program_.timeLimit = 0.5;
    const ProgramResult result = shell("sleep 600 & echo $! > child; echo waiting >&2; wait");
    EXPECT_TRUE(result.timedOut);
    EXPECT_FALSE(result.succeeded());
    EXPECT_GE(result.seconds, 0.5);
    EXPECT_LT(result.seconds, 30);
    EXPECT_EQ(result.errorText, "waiting\n");
    EXPECT_TRUE(gone("child"));
}

TEST_F(Program, WhatItLeavesBehindIsEndedAndNotWaitedFor) {
    const ProgramResult result = shell("sleep 600 & echo $! > child; exit 3");
    EXPECT_EQ(result.exitCode, 3);
    EXPECT_LT(result.seconds, 30);
    EXPECT_TRUE(gone("child"));
}

TEST_F(Program, LongErrorTextsKeepTheirEnd) {
    const ProgramResult result = shell("i=0; while [ $i -lt 9000 ]; do echo line$i >&2; i=$((i+1)); done");
    EXPECT_LE(result.errorText.size(), 16u * 1024);
    EXPECT_THAT(result.errorText, testing::EndsWith("line8999\n"));
}

TEST_F(Program, MemoryAndCpuLimitsAreSet) {
    program_.memoryLimit = 512ull << 20;
    program_.cpuLimit = 9;
    EXPECT_EQ(shell("ulimit -v >&2; ulimit -t >&2; ulimit -c >&2").errorText, "524288\n9\n0\n");
}

TEST_F(Program, TheMemoryLimitEndsWhatTakesTooMuch) {
    program_.memoryLimit = 512ull << 20;
    // Address space that is only reserved, so that the machine's own memory decides nothing.
    const auto reserve = [&](int megabytes) {
        return shell("/usr/bin/python3 -c 'import mmap; mmap.mmap(-1, " + std::to_string(megabytes) +
                     " << 20, flags=mmap.MAP_PRIVATE | mmap.MAP_ANONYMOUS | 0x4000)'");
    };
    EXPECT_TRUE(reserve(128).succeeded());
    const ProgramResult result = reserve(600);
    EXPECT_FALSE(result.succeeded());
    EXPECT_THAT(result.errorText, testing::HasSubstr("Cannot allocate memory"));
    program_.memoryLimit = 0;
    EXPECT_TRUE(reserve(600).succeeded()) << "without a limit";
}

TEST_F(Program, FilesItMayNotHaveAreNotThereForIt) {
    if (!FileRules::areKnown()) GTEST_SKIP() << "skipped: this kernel has no Landlock";
    const auto inner = program_.directory / "inner", beside = program_.directory / "beside";
    for (const auto& folder : {inner, beside}) {
        std::filesystem::create_directories(folder);
        writeFile(folder / "text", "words\n");
    }
    program_.directory = inner;
    program_.files =
        FileAccess{{"/usr", "/bin", "/lib", "/lib64", "/etc/ld.so.cache", "/does/not/exist"}, inner};
    EXPECT_EQ(shell("cat text >&2; echo more > made; cat made >&2; rm made; ls >&2").errorText,
              "words\nmore\ntext\n");
    for (const char* refused :
         {"cat ../beside/text", "echo x > ../beside/text", "echo x > ../beside/new", "rm ../beside/text",
          "mkdir ../beside/folder", "mv text ../beside/moved", "ln -s ../beside/text link && cat link",
          "ls ..", "cat /etc/passwd", "cat /proc/self/environ", "echo x > /usr/made",
          "sh -c 'cat ../beside/text'"}) {
        const ProgramResult result = shell(refused);
        EXPECT_FALSE(result.succeeded()) << refused;
        EXPECT_THAT(result.errorText, HasSubstr("Permission denied")) << refused;
    }
    EXPECT_EQ(readFile(beside / "text"), "words\n");
    program_.files.reset();
    EXPECT_EQ(shell("cat ../beside/text >&2").errorText, "words\n");
}

TEST_F(Program, AStopSignalEndsItAndIsThrown) {
    try {
        shell("echo $$ > self; kill -INT $PPID; sleep 600");
        FAIL() << "not interrupted";
    } catch (const Interrupted& interrupted) {
        EXPECT_EQ(interrupted.signal(), SIGINT);
    }
    EXPECT_TRUE(gone("self"));
    EXPECT_THROW(stop_.check(), Interrupted);
    sigset_t interrupt;
    sigemptyset(&interrupt);
    sigaddset(&interrupt, SIGINT);
    int taken = 0;
    ASSERT_EQ(sigwait(&interrupt, &taken), 0); // take it, or it would end the tests
}

TEST_F(Program, SearchTakesTheFirstExecutableFile) {
    const auto folder = program_.directory;
    for (const char* name : {"a", "b", "c"}) std::filesystem::create_directory(folder / name);
    writeFile(folder / "a" / "tool", "not executable");
    for (const char* name : {"b", "c"}) {
        writeFile(folder / name / "tool", "#!/bin/sh\n");
        std::filesystem::permissions(folder / name / "tool", std::filesystem::perms::owner_all);
    }
    std::filesystem::permissions(folder / "a" / "tool", std::filesystem::perms::owner_read);
    EXPECT_EQ(findProgram("tool", {folder, folder / "a", folder / "b", folder / "c"}), folder / "b" / "tool");
    EXPECT_EQ(findProgram("a", {folder}), std::nullopt) << "a folder is no program";
    EXPECT_EQ(findProgram("none", {folder}), std::nullopt);
}

} // namespace
} // namespace yarte::validate
