// Camera and lights as nodes.
#pragma once

#include "convert/gltf/write_body.h"

namespace yarte::convert::gltf {

/// The node's index. `extent`: of the bodies; nothing without any.
std::size_t writeCamera(const Camera&, const std::optional<Extent>& extent, Output&);

/// In candela, so that at the bodies' middle it gives the brightness that YARTE's light has everywhere.
double intensityOf(const Light&, const std::optional<Extent>&);

std::vector<std::size_t> writeLights(const std::vector<Light>&, const std::optional<Extent>&, Output&);

} // namespace yarte::convert::gltf
