// The report as one HTML file that needs nothing else: style, script, data and pictures are inside.
#pragma once

#include "validate/report.h"

#include <filesystem>
#include <string>

namespace yarte::validate {

/// `folder`: where the cases' pictures are. Throws FileError if one cannot be read.
std::string htmlReport(const Report&, const std::filesystem::path& folder);

} // namespace yarte::validate
