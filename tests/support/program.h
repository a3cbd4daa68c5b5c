// Running one of our programs as a user does, and looking at what it leaves.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include <sys/types.h>

namespace yarte::test {

struct ProgramResult {
    int exitCode = 0; ///< or minus the signal that ended it
    std::string out, err;
};

/// Of the program that is run; 0: none.
struct ProgramLimits {
    std::size_t fileSize = 0; ///< bytes; a write beyond fails with "file too large"
};

/// A program that runs in a folder of its own choice; killed if it is not waited for.
class Program {
public:
    /// `name` is one of ours, in YARTE_BIN_DIR; `environment` adds "NAME=value".
    Program(const std::string& name, const std::vector<std::string>& arguments,
            const std::filesystem::path& folder, const std::vector<std::string>& environment = {},
            ProgramLimits limits = {});
    ~Program();
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;

    pid_t id() const { return id_; }
    /// Its child processes that are alive now.
    std::vector<pid_t> children() const;
    /// What it has written to standard error up to now.
    std::string errors() const;
    bool hasEnded() const;
    ProgramResult wait();

private:
    pid_t id_ = -1;
    int out_ = -1, err_ = -1; ///< files in memory
    bool waited_ = false;
};

ProgramResult run(const std::string& name, const std::vector<std::string>& arguments,
                  const std::filesystem::path& folder, const std::vector<std::string>& environment = {},
                  ProgramLimits limits = {});

/// An empty folder for the running test, below YARTE_TEST_OUTPUT.
std::filesystem::path emptyTestFolder();

/// The names in a folder, sorted.
std::vector<std::string> namesIn(const std::filesystem::path& folder);

} // namespace yarte::test
