// The report as commands of GitHub's workflow runner, which shows them at the lines of the scenes.
#pragma once

#include "validate/report.h"

#include <filesystem>
#include <string>

namespace yarte::validate {

/// A line "::error file=...,line=...::..." for each cause of each case that does not pass; GitHub shows ten
/// of a step, so that each case has at most three. Files are named as seen from `root`, the repository's
/// folder.
std::string githubAnnotations(const Report&, const std::filesystem::path& root);

} // namespace yarte::validate
