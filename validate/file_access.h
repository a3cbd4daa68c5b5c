// What a program may do with files, held by the kernel (Landlock, since Linux 5.13): no language's own rules
// and no user's rights stand in between, root's neither.
#pragma once

#include "validate/descriptor.h"

#include <filesystem>
#include <vector>

namespace yarte::validate {

struct FileAccess {
    std::vector<std::filesystem::path>
        readable;                   ///< files, and folders with all in them, executables included
    std::filesystem::path writable; ///< the one folder where it may also write, make and remove
};

/// The rules of a FileAccess, ready to be laid on a process.
class FileRules {
public:
    /// What of `readable` does not exist is left out. Throws std::system_error.
    explicit FileRules(const FileAccess&);

    /// From now on they hold for this thread and all that it becomes or starts. False with errno if that
    /// failed; true also where the kernel has no Landlock. Safe between fork and exec.
    bool enforce() const;

    /// Whether the kernel can hold such rules.
    static bool areKnown();

private:
    Descriptor rules_; ///< -1: the kernel has no Landlock
};

} // namespace yarte::validate
