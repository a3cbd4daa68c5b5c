// OpenEXR's reader takes memory for what the header of a file says of its attributes, up to 2 GiB for each,
// before it finds that the file is shorter. So this is asked first.
#pragma once

#include <string_view>

namespace yarte::validate {

/// True if all attributes of the headers lie within the file and are of their types' sizes, or if the bytes are not OpenEXR's at all.
/// Source: "OpenEXR File Layout", Component Two: Header.
bool exrAttributesFit(std::string_view bytes);

} // namespace yarte::validate
