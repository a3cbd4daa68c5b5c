// Arrays of the language.
#pragma once

#include "convert/povray/sdl/value.h"

namespace yarte::convert::povray::sdl {

/// Arrays are values: a copy does not change with its original.
Value copied(const Value&);

} // namespace yarte::convert::povray::sdl
