// Writing glTF 2.0: what viewers can show of a scene, and all of it, exactly, in extras (convert/README.md).
#pragma once

#include "convert/format.h"

namespace yarte::convert::gltf {

/// JSON, and binary data in <stem>.bin beside it (within it on standard output).
std::vector<OutputFile> writeGltf(const Scene&, Conversion&);
std::vector<OutputFile> writeGlb(const Scene&, Conversion&);

} // namespace yarte::convert::gltf
