// What signals do to `yarte`: a render that is interrupted, killed, or loses workers leaves nothing behind.
#include "tests/support/program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <fstream>
#include <iterator>
#include <thread>

#include <sys/prctl.h>
#include <sys/wait.h>

namespace yarte::test {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;
using testing::IsEmpty;

const std::string paper = std::string(YARTE_SOURCE_DIR) + "/scenes/paper/paper.yarte";

/// Orphans of the programs run here become our children, so that we see whether any is left.
class YarteSignals : public testing::Test {
protected:
    YarteSignals() { prctl(PR_SET_CHILD_SUBREAPER, 1); }
    ~YarteSignals() override { prctl(PR_SET_CHILD_SUBREAPER, 0); }

    /// Waits until `yarte` has this many workers.
    static std::vector<pid_t> workersOf(const Program& yarte, std::size_t count) {
        for (const auto begin = std::chrono::steady_clock::now();
             std::chrono::steady_clock::now() - begin < 20s;) {
            const auto workers = yarte.children();
            if (workers.size() == count) return workers;
        }
        ADD_FAILURE() << "the workers did not appear";
        return {};
    }

    /// Waits until `yarte`, started with --progress=json, says that it renders.
    static void awaitProgress(const Program& yarte) {
        for (const auto begin = std::chrono::steady_clock::now();
             std::chrono::steady_clock::now() - begin < 60s;) {
            if (yarte.errors().find("\"done\"") != std::string::npos) return;
            std::this_thread::sleep_for(1ms);
        }
        ADD_FAILURE() << "the render did not begin";
    }

    /// True if no process is left that a program run here has started, dead ones included.
    static bool nothingIsLeft() { return waitpid(-1, nullptr, WNOHANG) < 0 && errno == ECHILD; }

    const fs::path folder_ = emptyTestFolder();
    /// A picture that takes far longer than any test waits.
    const std::vector<std::string> endless_{paper, "--size", "8000x8000", "-o", "a.png"};

    std::vector<std::string> endless(const std::vector<std::string>& options) const {
        auto arguments = endless_;
        arguments.insert(arguments.end(), options.begin(), options.end());
        return arguments;
    }
};

TEST_F(YarteSignals, AnInterruptEndsTheRenderInEveryModeAndLeavesNothing) {
    struct Case {
        int signal, exitCode;
    };
    for (const Case c : {Case{SIGINT, 130}, {SIGTERM, 143}})
        for (const char* mode : {"--processes=3", "--processes=0", "--threads=3"}) {
            Program yarte("yarte", endless({mode, "--progress=json"}), folder_);
            if (mode == std::string("--processes=3")) workersOf(yarte, 3);
            awaitProgress(yarte);
            kill(yarte.id(), c.signal);
            const auto begin = std::chrono::steady_clock::now();
            const auto result = yarte.wait();
            EXPECT_LT(std::chrono::steady_clock::now() - begin, 5s);
            EXPECT_EQ(result.exitCode, c.exitCode) << mode;
            EXPECT_THAT(result.err, testing::EndsWith("yarte: interrupted\n")) << mode;
            EXPECT_TRUE(nothingIsLeft()) << mode;
            EXPECT_THAT(namesIn(folder_), IsEmpty()) << mode;
        }
}

TEST_F(YarteSignals, AnInterruptBeforeTheRenderEndsTheProgramToo) {
    for (const auto delay : {0us, 500us, 1000us, 2000us, 4000us, 8000us}) {
        Program yarte("yarte", endless({"--processes=2"}), folder_);
        std::this_thread::sleep_for(delay);
        kill(yarte.id(), SIGINT);
        const int exitCode = yarte.wait().exitCode;
        // Before the program runs, it has no handler and the signal itself ends it.
        EXPECT_TRUE(exitCode == 130 || exitCode == -SIGINT) << exitCode;
        EXPECT_TRUE(nothingIsLeft());
        EXPECT_THAT(namesIn(folder_), IsEmpty());
    }
}

TEST_F(YarteSignals, WorkersEndWithAParentThatIsKilled) {
    Program yarte("yarte", endless({"--processes=3"}), folder_);
    const auto workers = workersOf(yarte, 3);
    kill(yarte.id(), SIGKILL);
    EXPECT_EQ(yarte.wait().exitCode, -SIGKILL);
    for (const pid_t worker : workers) {
        int status = 0;
        EXPECT_EQ(waitpid(worker, &status, 0), worker); // comes back only when it has ended
        // Killed; or it had just been forked, and left by itself when it found its parent gone.
        EXPECT_TRUE((WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL) ||
                    (WIFEXITED(status) && WEXITSTATUS(status) == 1))
            << status;
    }
    EXPECT_TRUE(nothingIsLeft());
    EXPECT_THAT(namesIn(folder_), IsEmpty());
}

TEST_F(YarteSignals, AWorkerThatIsLostOrStoppedIsReplacedAndThePictureIsTheSame) {
    const auto picture = [&](const std::vector<std::string>& mode, int signal) {
        std::vector<std::string> arguments{paper, "--size", "1000x800", "-o", "a.pfm"};
        arguments.insert(arguments.end(), mode.begin(), mode.end());
        Program yarte("yarte", arguments, folder_);
        if (signal != 0) kill(workersOf(yarte, 2).at(0), signal);
        const auto result = yarte.wait();
        EXPECT_EQ(result.exitCode, 0) << result.err;
        std::ifstream in(folder_ / "a.pfm", std::ios::binary);
        return std::string(std::istreambuf_iterator<char>(in), {});
    };
    const std::string reference = picture({"--processes=0"}, 0);
    ASSERT_GT(reference.size(), 1000u * 800 * 12);
    for (const int signal : {SIGKILL, SIGSTOP})
        EXPECT_EQ(picture({"--processes=2", "--tile=400"}, signal), reference) << signal;
    EXPECT_TRUE(nothingIsLeft());
}

TEST_F(YarteSignals, ASecondDeathOnTheSameTileEndsTheRenderByItsName) {
    Program yarte("yarte", endless({"--processes=1", "--tile=8000"}), folder_); // a single tile
    // A worker first needs the time to take the tile; a death before that is not the tile's. So on a busy
    // machine it may be more than two workers that die.
    for (const auto begin = std::chrono::steady_clock::now();
         !yarte.hasEnded() && std::chrono::steady_clock::now() - begin < 60s;) {
        std::this_thread::sleep_for(500ms);
        for (const pid_t worker : yarte.children()) kill(worker, SIGKILL);
    }
    const auto result = yarte.wait();
    EXPECT_EQ(result.exitCode, 3);
    EXPECT_EQ(result.err, "yarte: tile (0,0)-(8000,8000): its worker died twice (signal 9)\n");
    EXPECT_TRUE(nothingIsLeft());
    EXPECT_THAT(namesIn(folder_), IsEmpty());
}

} // namespace
} // namespace yarte::test
