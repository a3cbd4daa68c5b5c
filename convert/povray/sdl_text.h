// Values as SDL text. Every number reads back to the last bit.
#pragma once

#include "yarte/base/colour.h"
#include "yarte/base/frame.h"
#include "yarte/base/source.h"

#include <string>
#include <string_view>

namespace yarte::convert::povray {

std::string sdl(Vec3);                       ///< <1, 2, 3>
std::string sdl(Colour);                     ///< <1, 0.5, 0>
std::string sdl(const Frame&);               ///< <1, 0, 0>, <0, 1, 0>, <0, 0, 1>
std::string sdlGrey(Colour);                 ///< 0.8 where the channels are equal, else <1, 0.5, 0>
std::string stringLiteral(std::string_view); ///< "text", escaped

/// "sphere, line 12" for a comment; without the line if the place is unknown.
std::string placeOf(std::string_view kind, Span, const Sources&);

} // namespace yarte::convert::povray
