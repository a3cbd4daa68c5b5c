// The extent of objects as POV-Ray's min_extent and max_extent tell it.
#pragma once

#include "convert/povray/sdl/model.h"

#include <array>
#include <optional>

namespace yarte::convert::povray::sdl {

/// The lowest and the highest corner, axis-parallel. None of a shape whose extent is not known, or that has
/// none.
std::optional<std::array<Vec3, 2>> extentOf(const Object&);

} // namespace yarte::convert::povray::sdl
