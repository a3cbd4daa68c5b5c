// The ledger of what is written.
#pragma once

#include "convert/gltf/write_body.h"

namespace yarte::convert::gltf {

struct Written {
    const std::vector<ShownBody>& bodies;
    const std::optional<Extent>& extent;
    const std::vector<bool>& isUsed; ///< by material
    const std::vector<bool>& isSaid; ///< by mesh
};

/// A row for every property of the scene; and, on the screen, how far triangles are from what they stand for.
void report(const Scene&, const Written&, Conversion&);

} // namespace yarte::convert::gltf
