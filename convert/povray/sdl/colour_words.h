// The words that colours are written with: rgb, red, ...
#pragma once

#include <string_view>

namespace yarte::convert::povray::sdl {

/// A colour part's index, -1 if the word is none.
int channel(std::string_view word);
bool isColourWord(std::string_view);

} // namespace yarte::convert::povray::sdl
