// Workshop: the folder that a case's programs run in, and the record of what was run there.
#pragma once

#include "validate/program.h"
#include "validate/report.h"
#include "validate/temporary_folder.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace yarte::validate {

class Workshop {
public:
    /// Each program may run for `timeLimit` seconds.
    Workshop(const std::filesystem::path& parent, double timeLimit, const StopSignal&);

    std::filesystem::path file(const std::string& name) const { return folder_.path() / name; }

    /// Runs a program here and records it. Of the user's environment it sees nothing: HOME and TMPDIR are
    /// this folder. `memoryLimit` in bytes of address space, 0 for none. With `readable` it may read these
    /// files and folders, and write here, and have no others.
    ProgramResult run(const std::vector<std::string>& command, std::uint64_t memoryLimit = 0,
                      const std::optional<std::vector<std::filesystem::path>>& readable = {});

    /// Records a program that need not be run.
    void record(const std::vector<std::string>& command, const std::string& outcome);

    const std::vector<CommandRecord>& commands() const { return commands_; }

private:
    TemporaryFolder folder_;
    double timeLimit_;
    const StopSignal& stop_;
    std::vector<CommandRecord> commands_;
};

/// How a program ended, in words: "exit code 1", "killed by signal 11 (Segmentation fault)".
std::string outcome(const ProgramResult&);

} // namespace yarte::validate
