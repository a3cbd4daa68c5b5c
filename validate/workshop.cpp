#include "validate/workshop.h"

#include "validate/text.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fmt/format.h>
#include <thread>

namespace yarte::validate {

Workshop::Workshop(const std::filesystem::path& parent, double timeLimit, const StopSignal& stop)
    : folder_(parent), timeLimit_(timeLimit), stop_(stop) {}

ProgramResult Workshop::run(const std::vector<std::string>& command, std::uint64_t memoryLimit,
                            const std::optional<std::vector<std::filesystem::path>>& readable) {
    ProgramRun program;
    program.command = command;
    program.directory = folder_.path();
    program.environment = {"HOME=" + folder_.path().string(), "TMPDIR=" + folder_.path().string(),
                           "PATH=/usr/local/bin:/usr/bin:/bin", "LC_ALL=C"};
    program.timeLimit = timeLimit_;
    program.memoryLimit = memoryLimit;
    if (readable) program.files = FileAccess{*readable, folder_.path()};
    // What a program computes must end too if it escapes the wall clock by leaving its process group.
    program.cpuLimit =
        static_cast<std::uint64_t>(std::ceil(timeLimit_)) * std::max(1u, std::thread::hardware_concurrency());
    const ProgramResult result = validate::run(program, stop_);
    commands_.push_back({cleanText(shellCommand(command)), result.seconds, outcome(result)});
    return result;
}

void Workshop::record(const std::vector<std::string>& command, const std::string& outcome) {
    commands_.push_back({cleanText(shellCommand(command)), 0, outcome});
}

std::string outcome(const ProgramResult& result) {
    if (!result.startError.empty()) return fmt::format("not started: {}", result.startError);
    if (result.timedOut) return fmt::format("stopped after {:.1f} s, the time limit", result.seconds);
    if (result.signal != 0)
        return fmt::format("killed by signal {} ({})", result.signal, ::strsignal(result.signal));
    return fmt::format("exit code {}", result.exitCode);
}

} // namespace yarte::validate
