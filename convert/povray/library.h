// The macros at the top of every SDL file: YARTE's shading and shapes said with POV-Ray's means.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace yarte::convert::povray {

/// The macros that `text` uses, directly or through others. `plain`: the fastest textures rather than the
/// exact ones.
std::string libraryFor(std::string_view text, bool plain);

/// True if the macro `name` of the library reads just so: "#macro NAME(...) ... #end".
bool isLibraryMacro(std::string_view name, std::string_view text);
/// The names of all macros that make up the library.
std::vector<std::string_view> libraryMacroNames();

} // namespace yarte::convert::povray
