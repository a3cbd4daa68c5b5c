// ProcessPool: forked workers of this process, none of which outlives it.
#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <csignal>
#include <sys/types.h>

namespace yarte {

class ProcessPool {
public:
    /// How a worker ended.
    struct Ending {
        int worker = 0;
        int status = 0;          ///< as of waitpid
        bool wasStopped = false; ///< and was killed for that
        bool good() const { return status == 0; }
        std::string text() const; ///< "signal 9", "exit code 1"
    };

    ProcessPool();
    /// Kills and reaps the workers that are left.
    ~ProcessPool();
    ProcessPool(const ProcessPool&) = delete;
    ProcessPool& operator=(const ProcessPool&) = delete;

    /// Forks a worker that does `work(worker)` and leaves with exit code 0, or 1 after an exception. It
    /// ignores SIGINT (the terminal sends it to all; we decide) and is killed when the thread that started it
    /// ends. Throws RenderError if there is no process to be had.
    void start(int worker, const std::function<void(int worker)>& work);

    bool empty() const { return processes_.empty(); }

    /// Sleeps until a worker ends, a signal is handled or the time is over; tells who has ended meanwhile.
    /// A worker that a signal stopped (SIGSTOP, SIGTSTP) and that nobody has continued for longestStop is
    /// killed, since it would hold what it holds for ever.
    std::vector<Ending> wait(std::chrono::milliseconds atMost);

    static constexpr std::chrono::seconds longestStop{2};

private:
    using Clock = std::chrono::steady_clock;
    struct Process {
        pid_t pid;
        int worker;
        std::optional<Clock::time_point> stopped{}; ///< when that was seen
    };
    std::vector<Ending> reap();
    void killStopped();

    std::vector<Process> processes_;
    // For the pool's life SIGCHLD has its default action and is blocked: wait() sleeps for it and misses
    // none.
    struct sigaction outerAction_ {};
    sigset_t outerMask_{};
};

} // namespace yarte
