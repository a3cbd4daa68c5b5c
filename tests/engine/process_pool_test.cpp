#include "yarte/engine/process_pool.h"

#include "yarte/engine/shared_memory.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cerrno>
#include <new>
#include <stdexcept>
#include <thread>

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace yarte {
namespace {

using namespace std::chrono_literals;

void sleepForEver(int) {
    for (;;) pause();
}

bool hasNoChild() { return waitpid(-1, nullptr, WNOHANG) < 0 && errno == ECHILD; }

/// The one ending that comes.
ProcessPool::Ending endingOf(const std::function<void(int)>& work) {
    ProcessPool pool;
    pool.start(3, work);
    while (true) {
        const auto endings = pool.wait(1s);
        if (!endings.empty()) return endings[0];
    }
}

TEST(ProcessPool, TellsHowAWorkerEnded) {
    const auto good = endingOf([](int) {});
    EXPECT_TRUE(good.good());
    EXPECT_EQ(good.worker, 3);
    const auto thrown = endingOf([](int) { throw std::runtime_error("no"); });
    EXPECT_FALSE(thrown.good());
    EXPECT_EQ(thrown.text(), "exit code 1");
    const auto left = endingOf([](int worker) { _exit(worker + 4); });
    EXPECT_EQ(left.text(), "exit code 7");
    const auto killed = endingOf([](int) { raise(SIGKILL); });
    EXPECT_FALSE(killed.good());
    EXPECT_EQ(killed.text(), "signal 9");
    EXPECT_TRUE(hasNoChild());
}

TEST(ProcessPool, DestructorKillsAndReaps) {
    {
        ProcessPool pool;
        for (int worker = 0; worker < 5; ++worker) pool.start(worker, sleepForEver);
        EXPECT_FALSE(pool.empty());
    }
    EXPECT_TRUE(hasNoChild());
}

TEST(ProcessPool, WaitSleepsUntilTheTimeIsOver) {
    ProcessPool pool;
    pool.start(0, sleepForEver);
    const auto begin = std::chrono::steady_clock::now();
    EXPECT_TRUE(pool.wait(50ms).empty());
    EXPECT_GE(std::chrono::steady_clock::now() - begin, 50ms);
}

TEST(ProcessPool, WorkersIgnoreInterruptsAndEndOnTermination) {
    const auto interrupted = endingOf([](int) { raise(SIGINT); });
    EXPECT_TRUE(interrupted.good());
    const auto terminated = endingOf([](int) { raise(SIGTERM); });
    EXPECT_EQ(terminated.text(), "signal 15");
}

TEST(ProcessPool, AStoppedWorkerIsKilledUnlessItIsContinuedInTime) {
    const auto begin = std::chrono::steady_clock::now();
    const auto stopped = endingOf([](int) { raise(SIGSTOP); });
    EXPECT_EQ(stopped.text(), "signal 9");
    EXPECT_TRUE(stopped.wasStopped);
    EXPECT_GE(std::chrono::steady_clock::now() - begin, ProcessPool::longestStop);

    const auto continued = endingOf([](int) {
        const pid_t self = getpid();
        if (fork() == 0) { // a helper that continues it, once it has surely been seen
            std::this_thread::sleep_for(500ms);
            kill(self, SIGCONT);
            _exit(0);
        }
        raise(SIGSTOP);
        std::this_thread::sleep_for(ProcessPool::longestStop + 500ms);
        while (wait(nullptr) < 0 && errno == EINTR) {
        }
    });
    EXPECT_TRUE(continued.good()) << continued.text();
    EXPECT_FALSE(continued.wasStopped);
    EXPECT_TRUE(hasNoChild());
}

TEST(ProcessPool, LeavesTheSignalsOfItsMakerAsTheyWere) {
    std::signal(SIGCHLD, SIG_IGN);
    EXPECT_TRUE(endingOf([](int) {}).good()) << "ignoring SIGCHLD must not lose the status";
    EXPECT_EQ(std::signal(SIGCHLD, SIG_DFL), SIG_IGN);
    sigset_t mask;
    pthread_sigmask(SIG_BLOCK, nullptr, &mask);
    EXPECT_EQ(sigismember(&mask, SIGCHLD), 0);
}

TEST(ProcessPool, WorkersDieWithTheirParentEvenWhenItIsKilled) {
    constexpr int workers = 3;
    const SharedMemory memory = mapSharedMemory(workers * sizeof(std::atomic<pid_t>));
    auto* const pids = new (memory.get()) std::atomic<pid_t>[workers];
    ASSERT_EQ(prctl(PR_SET_CHILD_SUBREAPER, 1), 0); // orphans become our children, so that we see them end

    const pid_t parent = fork();
    if (parent == 0) {
        ProcessPool pool;
        for (int worker = 0; worker < workers; ++worker)
            pool.start(worker, [pids](int self) {
                pids[self] = getpid();
                sleepForEver(self);
            });
        sleepForEver(0);
    }
    for (int worker = 0; worker < workers; ++worker)
        while (pids[worker] == 0) std::this_thread::sleep_for(1ms);
    kill(parent, SIGKILL);
    ASSERT_EQ(waitpid(parent, nullptr, 0), parent);
    for (int worker = 0; worker < workers; ++worker) {
        int status = 0;
        ASSERT_EQ(waitpid(pids[worker], &status, 0), pids[worker]);
        EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL);
    }
    prctl(PR_SET_CHILD_SUBREAPER, 0);
    EXPECT_TRUE(hasNoChild());
}

} // namespace
} // namespace yarte
