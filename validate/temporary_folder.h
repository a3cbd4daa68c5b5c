// TemporaryFolder: a new, private folder that goes, with all that is in it, when its owner does.
#pragma once

#include <filesystem>

namespace yarte::validate {

class TemporaryFolder {
public:
    /// Throws std::filesystem::filesystem_error.
    explicit TemporaryFolder(const std::filesystem::path& parent);
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

} // namespace yarte::validate
