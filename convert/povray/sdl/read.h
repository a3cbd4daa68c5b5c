// Reads POV-Ray's scene description language. How everything in it becomes YARTE's is in convert/README.md.
#pragma once

#include "convert/format.h"

namespace yarte::convert::povray {

/// The scene, or nothing after reporting why, with where macros were called and files included.
std::optional<Scene> readScene(Conversion&);

} // namespace yarte::convert::povray
