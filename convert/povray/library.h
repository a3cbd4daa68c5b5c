// The macros at the top of every SDL file: YARTE's shading and shapes said with POV-Ray's means.
#pragma once

#include <string>
#include <string_view>

namespace yarte::convert::povray {

/// The macros that `text` uses, directly or through others. `plain`: the fastest textures rather than the
/// exact ones.
std::string libraryFor(std::string_view text, bool plain);

} // namespace yarte::convert::povray
