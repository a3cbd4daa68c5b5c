// Files: reading whole ones, writing them so that no half-written one is ever seen, and staying in a folder.
#pragma once

#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace yarte {

/// The machine would not do it (missing, no permission, disk full). what() is "FILE: reason". Exit code 3.
class FileError : public std::runtime_error {
public:
    FileError(const std::filesystem::path& file, std::string_view reason);
    const std::string& reason() const { return reason_; }

private:
    std::string reason_;
};

/// The bytes of a regular file (or pipe). Throws FileError, also for a directory.
std::string readFile(const std::filesystem::path& file);

/// Why `file` is no regular file that can be read, in words; nothing if it is.
std::optional<std::string> whyUnreadable(const std::filesystem::path& file);

/// Writes `bytes` to a temporary file beside `file`, flushes it and renames it to `file`; on any failure the
/// temporary file is removed, an existing `file` stays as it was, and FileError is thrown. A device or pipe takes the
/// bytes directly.
void writeFile(const std::filesystem::path& file, std::string_view bytes);

/// The folders a scene may read from: its own, and those the user allows.
struct ReadableFolders {
    std::vector<std::filesystem::path> folders;

    /// True if `file`, with links and ".." resolved, lies in one of the folders or below.
    bool contain(const std::filesystem::path& file) const;
};

/// From now on a write beyond the process's largest file size (ulimit -f) fails as one to a full disk does; otherwise
/// the system's signal for it ends the process without a word.
void letLargeWritesFail();

} // namespace yarte
