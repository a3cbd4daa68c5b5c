// Running other programs: without a shell, in an environment of our making, within limits, and leaving
// nothing behind.
#pragma once

#include "validate/file_access.h"
#include "validate/stop_signal.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace yarte::validate {

struct ProgramRun {
    std::vector<std::string> command;     ///< [0] is the program's path
    std::filesystem::path directory;      ///< where it runs; must exist
    std::vector<std::string> environment; ///< "NAME=value"; the program sees nothing else
    double timeLimit = 600;               ///< seconds of wall clock
    std::uint64_t memoryLimit = 0;        ///< bytes of address space; 0: none
    std::uint64_t cpuLimit = 0;           ///< seconds, summed over threads; 0: none
    std::optional<FileAccess> files{};    ///< what it may do with files; nothing: what this process may
};

/// How it ended. Exactly one of `startError`, `timedOut`, `signal`, or just `exitCode`.
struct ProgramResult {
    std::string startError; ///< why it could not be started; else empty
    bool timedOut = false;
    int signal = 0; ///< that killed it, other than at the time-out
    int exitCode = 0;
    double seconds = 0;    ///< wall clock
    std::string errorText; ///< what it wrote to standard error, cleaned; the end if that is long
    bool succeeded() const { return startError.empty() && !timedOut && signal == 0 && exitCode == 0; }
};

/// Runs the program with standard input empty and standard output discarded, as the leader of a process
/// group. When it ends, by itself or at the limit, what is left of its group is killed. Throws Interrupted,
/// after killing the group; std::system_error if this process has no resources for a child.
ProgramResult run(const ProgramRun&, const StopSignal&);

/// The first of `folders` with an executable file `name`; nothing if there is none.
std::optional<std::filesystem::path> findProgram(const std::string& name,
                                                 const std::vector<std::filesystem::path>& folders);

} // namespace yarte::validate
