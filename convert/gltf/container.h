// The container of a glTF file: JSON alone, or a .glb with JSON and binary data (glTF 2.0 section 4.4).
#pragma once

#include "yarte/base/diagnostic.h"

#include <optional>
#include <string>
#include <string_view>

namespace yarte::convert::gltf {

struct Container {
    std::string_view json;
    std::optional<std::string_view> binary; ///< the first buffer
};

/// The parts of `bytes`, or nothing after reporting what is wrong with them.
std::optional<Container> openContainer(std::string_view bytes, const std::string& file, Diagnostics&);

} // namespace yarte::convert::gltf
