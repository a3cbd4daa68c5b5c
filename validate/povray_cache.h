// PovrayCache: pictures that POV-Ray made, found again by what it was given. Any file of it may be deleted at
// any time, and several programs may use it at once.
#pragma once

#include "validate/report.h"

#include <filesystem>
#include <optional>
#include <string>

namespace yarte::validate {

class PovrayCache {
public:
    struct Entry {
        std::string picture; ///< the bytes of POV-Ray's file
        PovrayTimes times;   ///< of the run that made it
    };

    /// The folder is made when something is stored.
    explicit PovrayCache(std::filesystem::path folder) : folder_(std::move(folder)) {}

    /// What was stored for `input`: everything that decides the picture. A damaged file is as good as none.
    std::optional<Entry> find(const std::string& input) const;

    /// Throws FileError or std::filesystem::filesystem_error.
    void store(const std::string& input, const Entry&) const;

private:
    std::filesystem::path fileOf(const std::string& input) const;

    std::filesystem::path folder_;
};

} // namespace yarte::validate
