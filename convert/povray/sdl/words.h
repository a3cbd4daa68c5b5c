// Words that SDL reserves: none of them can be declared.
#pragma once

#include <string_view>

namespace yarte::convert::povray::sdl {

bool isReserved(std::string_view word);

/// True for the keywords that begin an object.
bool isObjectKeyword(std::string_view word);

} // namespace yarte::convert::povray::sdl
