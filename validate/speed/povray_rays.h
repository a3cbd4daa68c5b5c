// Single rays through POV-Ray: a program in its language that asks trace() and prints the answers with all
// their digits.
#pragma once

#include "validate/speed/measure_rays.h"

#include <string>
#include <string_view>
#include <vector>

namespace yarte::validate {

/// A ray, and the body that POV-Ray is asked for: trace() tells where it meets an object, not which it meets.
struct RayQuestion {
    Vec3 origin, direction;
    int body = -1;
};

/// `sdl`, as yarte-convert writes it, with a name for each body instead of its place in the scene, and the
/// questions, whose answers go to `file`. Throws CaseError unless there are `bodies` bodies.
std::string askingScene(std::string_view sdl, std::size_t bodies, const std::vector<RayQuestion>&,
                        std::string_view file);

/// One answer for each question, in their order. Throws CaseError.
std::vector<RayAnswer> answersIn(std::string_view text, const std::vector<RayQuestion>&);

} // namespace yarte::validate
