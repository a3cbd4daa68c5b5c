// POV-Ray's answers: by trace() in its scene language, which meets a ray with an object in double precision.
#pragma once

#include "tests/hard/check.h"
#include "tests/hard/others/other_answer.h"

#include <filesystem>
#include <span>
#include <vector>

namespace yarte::hard {

/// One answer per case. Each object is written as yarte-convert writes it, scaled by a power of two, which
/// rounds nothing, so that POV-Ray's absolute tolerances do not decide: its scene is a million units large.
/// Not asked: cases in which something is crossed that is then still nearer than 1/64 to the ray's start,
/// ahead or behind, and meshes. Throws std::runtime_error if POV-Ray fails.
std::vector<OtherAnswer> askPovray(const std::filesystem::path& povray, std::span<const Case>);

} // namespace yarte::hard
