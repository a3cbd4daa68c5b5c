#include "tests/support/program.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <system_error>

#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace yarte::test {

namespace fs = std::filesystem;

namespace {

std::string contents(int file) {
    std::string text;
    char block[4096];
    ssize_t size = 0;
    while ((size = pread(file, block, sizeof block, static_cast<off_t>(text.size()))) > 0)
        text.append(block, static_cast<std::size_t>(size));
    return text;
}

[[noreturn]] void execute(const std::string& file, const std::vector<std::string>& arguments,
                          const fs::path& folder, const std::vector<std::string>& environment,
                          ProgramLimits limits, int out, int err) {
    std::vector<char*> words;
    words.push_back(const_cast<char*>(file.c_str()));
    for (const std::string& argument : arguments) words.push_back(const_cast<char*>(argument.c_str()));
    words.push_back(nullptr);
    for (const std::string& variable : environment) putenv(const_cast<char*>(variable.c_str()));
    if (limits.fileSize > 0) {
        const rlimit fileSize{limits.fileSize, limits.fileSize};
        setrlimit(RLIMIT_FSIZE, &fileSize);
        std::signal(SIGXFSZ, SIG_DFL); // as a shell starts it
    }
    if (chdir(folder.c_str()) == 0 && dup2(out, STDOUT_FILENO) >= 0 && dup2(err, STDERR_FILENO) >= 0)
        execv(file.c_str(), words.data());
    _exit(126);
}

} // namespace

Program::Program(const std::string& name, const std::vector<std::string>& arguments, const fs::path& folder,
                 const std::vector<std::string>& environment, ProgramLimits limits)
    : out_(memfd_create("out", MFD_CLOEXEC)), err_(memfd_create("err", MFD_CLOEXEC)) {
    const std::string file = std::string(YARTE_BIN_DIR) + "/" + name;
    id_ = fork();
    if (id_ == 0) execute(file, arguments, folder, environment, limits, out_, err_);
    if (id_ < 0) throw std::system_error(errno, std::generic_category(), "fork");
}

Program::~Program() {
    if (!waited_) {
        kill(id_, SIGKILL);
        wait();
    }
    close(out_);
    close(err_);
}

std::vector<pid_t> Program::children() const {
    std::ifstream list("/proc/" + std::to_string(id_) + "/task/" + std::to_string(id_) + "/children");
    std::vector<pid_t> ids;
    for (pid_t id = 0; list >> id;) ids.push_back(id);
    return ids;
}

std::string Program::errors() const { return contents(err_); }

bool Program::hasEnded() const {
    siginfo_t info{};
    return waitid(P_PID, static_cast<id_t>(id_), &info, WEXITED | WNOHANG | WNOWAIT) == 0 && info.si_pid == id_;
}

ProgramResult Program::wait() {
    int status = 0;
    while (waitpid(id_, &status, 0) < 0 && errno == EINTR) {
    }
    waited_ = true;
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status), contents(out_), contents(err_)};
}

ProgramResult run(const std::string& name, const std::vector<std::string>& arguments, const fs::path& folder,
                  const std::vector<std::string>& environment, ProgramLimits limits) {
    return Program(name, arguments, folder, environment, limits).wait();
}

fs::path emptyTestFolder() {
    const auto* const info = testing::UnitTest::GetInstance()->current_test_info();
    const fs::path folder = fs::path(YARTE_TEST_OUTPUT) / info->test_suite_name() / info->name();
    fs::remove_all(folder);
    fs::create_directories(folder);
    return folder;
}

std::vector<std::string> namesIn(const fs::path& folder) {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder)) names.push_back(entry.path().filename());
    std::sort(names.begin(), names.end());
    return names;
}

} // namespace yarte::test
