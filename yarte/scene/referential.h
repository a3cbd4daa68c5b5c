// From axes as written to a rotation (SCENE-LANGUAGE decision D4).
#pragma once

#include "yarte/base/frame.h"
#include "yarte/scene/shapes.h"

#include <optional>
#include <string>

namespace yarte {

/// Axes farther than this from perpendicular are an error; smaller errors are removed.
inline constexpr double maxAxisError = 1e-3; ///< radians

/// What is wrong with the axes, in words with the angle; nothing if they are good.
std::optional<std::string> referentialError(const Referential&);

/// The versors normalised, the third completed, the closest rotation taken. The axes must be good.
Frame resolveReferential(const Referential&);

} // namespace yarte
