#include "yarte/engine/process_pool.h"

#include "yarte/engine/render_error.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace yarte {

namespace {

sigset_t childSignal() {
    sigset_t set;
    sigemptyset(&set);
    sigaddset(&set, SIGCHLD);
    return set;
}

/// The life of a forked worker. It never returns into the parent's code, nor runs the parent's exit handlers.
[[noreturn]] void live(pid_t parent, int worker, const std::function<void(int)>& work) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent) _exit(1); // it died before the line above
    std::signal(SIGINT, SIG_IGN);
    std::signal(SIGTERM, SIG_DFL);
    try {
        work(worker);
    } catch (...) {
        _exit(1);
    }
    _exit(0);
}

} // namespace

std::string ProcessPool::Ending::text() const {
    return WIFSIGNALED(status) ? fmt::format("signal {}", WTERMSIG(status))
                               : fmt::format("exit code {}", WEXITSTATUS(status));
}

ProcessPool::ProcessPool() {
    struct sigaction standard {};
    standard.sa_handler = SIG_DFL;
    sigaction(SIGCHLD, &standard, &outerAction_);
    const sigset_t set = childSignal();
    pthread_sigmask(SIG_BLOCK, &set, &outerMask_);
}

ProcessPool::~ProcessPool() {
    for (const Process& process : processes_) kill(process.pid, SIGKILL);
    for (const Process& process : processes_)
        while (waitpid(process.pid, nullptr, 0) < 0 && errno == EINTR) {
        }
    pthread_sigmask(SIG_SETMASK, &outerMask_, nullptr);
    sigaction(SIGCHLD, &outerAction_, nullptr);
}

void ProcessPool::start(int worker, const std::function<void(int)>& work) {
    processes_.reserve(processes_.size() + 1); // so that no process can be started and then forgotten
    const pid_t parent = getpid();
    const pid_t pid = fork();
    if (pid < 0) throw RenderError(fmt::format("cannot start a worker process: {}", std::strerror(errno)));
    if (pid == 0) live(parent, worker, work);
    processes_.push_back({pid, worker});
}

std::vector<ProcessPool::Ending> ProcessPool::wait(std::chrono::milliseconds atMost) {
    if (auto endings = reap(); !endings.empty()) return endings;
    const sigset_t set = childSignal();
    const auto seconds = std::chrono::floor<std::chrono::seconds>(atMost);
    const timespec timeout{seconds.count(), std::chrono::nanoseconds(atMost - seconds).count()};
    sigtimedwait(&set, nullptr, &timeout); // a child's end, the time's, or another signal: all are good
    return reap();
}

std::vector<ProcessPool::Ending> ProcessPool::reap() {
    std::vector<Ending> endings;
    std::erase_if(processes_, [&](Process& process) {
        int status = 0;
        if (waitpid(process.pid, &status, WNOHANG | WUNTRACED | WCONTINUED) != process.pid) return false;
        if (WIFSTOPPED(status) || WIFCONTINUED(status)) {
            process.stopped.reset();
            if (WIFSTOPPED(status)) process.stopped = Clock::now();
            return false;
        }
        endings.push_back({process.worker, status, process.stopped.has_value()});
        return true;
    });
    killStopped();
    return endings;
}

void ProcessPool::killStopped() {
    for (const Process& process : processes_)
        if (process.stopped && Clock::now() - *process.stopped > longestStop) kill(process.pid, SIGKILL);
}

} // namespace yarte
