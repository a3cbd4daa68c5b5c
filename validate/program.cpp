#include "validate/program.h"

#include "validate/descriptor.h"
#include "validate/text.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>

namespace yarte::validate {

namespace {

using Clock = std::chrono::steady_clock;

[[noreturn]] void throwErrno(const char* what) {
    throw std::system_error(errno, std::generic_category(), what);
}

struct Pipe {
    Descriptor read, write;
    Pipe() : Pipe(makeEnds()) {}

private:
    struct Ends {
        int values[2];
    };
    static Ends makeEnds() {
        Ends ends{};
        if (::pipe2(ends.values, O_CLOEXEC) != 0) throwErrno("pipe");
        return ends;
    }
    explicit Pipe(Ends ends) : read(ends.values[0]), write(ends.values[1]) {}
};

/// Standard error as it comes: memory stays bounded however much a program says. The end is kept, that is
/// where programs say why they stop.
class ErrorText {
public:
    /// Reads what is there without waiting for more; false at the end.
    bool readFrom(int descriptor) {
        char buffer[4096];
        ssize_t count = 0;
        while ((count = ::read(descriptor, buffer, sizeof buffer)) > 0) {
            text_.append(buffer, static_cast<std::size_t>(count));
            if (text_.size() > 2 * kept) text_.erase(0, text_.size() - kept);
        }
        return count < 0;
    }
    std::string cleaned() const {
        return cleanText(std::string_view(text_).substr(text_.size() > kept ? text_.size() - kept : 0));
    }

private:
    static constexpr std::size_t kept = 16 * 1024;
    std::string text_;
};

std::vector<char*> pointersTo(const std::vector<std::string>& strings) {
    std::vector<char*> pointers;
    pointers.reserve(strings.size() + 1);
    for (const std::string& string : strings) pointers.push_back(const_cast<char*>(string.c_str()));
    pointers.push_back(nullptr);
    return pointers;
}

void limit(__rlimit_resource resource, std::uint64_t value) {
    const rlimit both{value, value};
    ::setrlimit(resource, &both);
}

/// The child's side: only calls that are safe between fork and exec. Writes errno to `failure` if it comes
/// back.
[[noreturn]] void becomeProgram(const ProgramRun& run, const FileRules* files, char* const* arguments,
                                char* const* environment, int errorText, int failure) {
    ::setpgid(0, 0);
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    sigset_t none;
    sigemptyset(&none);
    ::sigprocmask(SIG_SETMASK, &none, nullptr);
    const int nothing = ::open("/dev/null", O_RDWR);
    ::dup2(nothing, STDIN_FILENO);
    ::dup2(nothing, STDOUT_FILENO);
    ::dup2(errorText, STDERR_FILENO);
    limit(RLIMIT_CORE, 0);
    if (run.memoryLimit > 0) limit(RLIMIT_AS, run.memoryLimit);
    if (run.cpuLimit > 0) limit(RLIMIT_CPU, run.cpuLimit);
    if (::chdir(run.directory.c_str()) == 0 && (files == nullptr || files->enforce()))
        ::execve(arguments[0], arguments, environment);
    const int reason = errno;
    [[maybe_unused]] const ssize_t written = ::write(failure, &reason, sizeof reason);
    ::_exit(127);
}

/// A started child; its whole group is killed and it is waited for, whatever happens.
class Child {
public:
    explicit Child(pid_t pid) : pid_(pid), descriptor_(static_cast<int>(::syscall(SYS_pidfd_open, pid, 0))) {
        if (descriptor_.get() < 0) {
            const int reason = errno;
            reap();
            throw std::system_error(reason, std::generic_category(), "pidfd_open");
        }
    }
    ~Child() { reap(); }
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;

    /// Readable once the child has ended.
    int descriptor() const { return descriptor_.get(); }
    /// Kills what is left of the group and returns the status of waitpid.
    int reap() {
        if (pid_ == 0) return status_;
        ::kill(-pid_, SIGKILL);
        while (::waitpid(pid_, &status_, 0) < 0 && errno == EINTR) {
        }
        pid_ = 0;
        return status_;
    }

private:
    pid_t pid_;
    Descriptor descriptor_;
    int status_ = 0;
};

/// Collects `text` until the child ends; false if `deadline` comes first.
bool waitForEnd(const Child& child, int errorPipe, Clock::time_point deadline, const StopSignal& stop,
                ErrorText& text) {
    pollfd events[] = {
        {child.descriptor(), POLLIN, 0}, {stop.descriptor(), POLLIN, 0}, {errorPipe, POLLIN, 0}};
    for (;;) {
        const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now()).count();
        if (left <= 0) return false;
        const int timeout = static_cast<int>(std::min<long>(left, 3'600'000));
        if (::poll(events, 3, timeout) < 0 && errno != EINTR) throwErrno("poll");
        stop.check();
        if (events[2].revents != 0 && !text.readFrom(errorPipe)) events[2].fd = -1;
        if (events[0].revents != 0) return true;
    }
}

} // namespace

ProgramResult run(const ProgramRun& run, const StopSignal& stop) {
    const std::vector<char*> arguments = pointersTo(run.command), environment = pointersTo(run.environment);
    std::optional<FileRules> files;
    if (run.files) files.emplace(*run.files);
    Pipe errors, failure;
    ::fcntl(errors.read.get(), F_SETFL, O_NONBLOCK);
    const auto start = Clock::now();
    const pid_t pid = ::fork();
    if (pid < 0) throwErrno("fork");
    if (pid == 0)
        becomeProgram(run, files ? &*files : nullptr, arguments.data(), environment.data(),
                      errors.write.get(), failure.write.get());
    ::setpgid(pid, pid); // here too: the group must exist before it may have to be killed
    Child child(pid);
    errors.write.close();
    failure.write.close();

    ProgramResult result;
    if (int reason = 0; ::read(failure.read.get(), &reason, sizeof reason) == sizeof reason) {
        result.startError = std::generic_category().message(reason);
        return result;
    }
    ErrorText text;
    const auto limit =
        std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(run.timeLimit));
    result.timedOut = !waitForEnd(child, errors.read.get(), start + limit, stop, text);
    result.seconds = std::chrono::duration<double>(Clock::now() - start).count();
    const int status = child.reap();
    text.readFrom(errors.read.get()); // what was still in the pipe
    result.errorText = text.cleaned();
    if (WIFEXITED(status)) result.exitCode = WEXITSTATUS(status);
    if (WIFSIGNALED(status) && !result.timedOut) result.signal = WTERMSIG(status);
    return result;
}

std::optional<std::filesystem::path> findProgram(const std::string& name,
                                                 const std::vector<std::filesystem::path>& folders) {
    for (const auto& folder : folders) {
        const auto candidate = folder / name;
        if (std::filesystem::is_regular_file(candidate) && ::access(candidate.c_str(), X_OK) == 0)
            return candidate;
    }
    return std::nullopt;
}

} // namespace yarte::validate
