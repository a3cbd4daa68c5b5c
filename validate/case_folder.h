// CaseFolder: what a case leaves in the report's folder, and in its page.
#pragma once

#include "validate/display.h"
#include "validate/flip.h"
#include "validate/picture.h"
#include "validate/report.h"
#include "validate/workshop.h"

#include <filesystem>
#include <optional>
#include <string>

namespace yarte::validate {

/// One of the two pictures of a case.
struct Side {
    std::string name;  ///< in messages
    std::string label; ///< in the report
    std::string file;  ///< in the case's folder
    std::optional<Picture> picture;
};

class CaseFolder {
public:
    /// Nothing of an earlier run may seem to belong to this one; what is not ours stays. The folder and the
    /// file operations below throw FileError or std::filesystem::filesystem_error.
    CaseFolder(CaseReport&, const std::filesystem::path& output);

    /// Keeps a file that a program may have left in the workshop.
    void keep(const Workshop&, const std::string& file) const;

    /// Writes what there is: both pictures, and their difference if they have one size. The page gets them in
    /// at most `pageLimit` bytes; FLIP is that of a compared pair, else the page shows one picture.
    void addPictures(const Side& a, const Side& b, const std::optional<FlipMap>&, double threshold,
                     std::size_t pageLimit);

private:
    void addPicture(const std::string& label, const std::string& file, const DisplayPicture&);

    CaseReport& report_;
    std::filesystem::path path_;
};

} // namespace yarte::validate
