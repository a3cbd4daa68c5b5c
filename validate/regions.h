// Regions: pixels that differ, put together where they lie together.
#pragma once

#include "validate/difference.h"
#include "validate/region.h"

#include <cstddef>
#include <vector>

namespace yarte::validate {

/// A region and its pixels, in reading order.
struct PixelGroup {
    Region region; ///< all but the finding
    std::vector<std::size_t> pixels;
};

/// Pixels belong together if they touch, also at corners, or if one single pixel lies between them. The
/// largest groups come first, of equal ones the first in reading order.
std::vector<PixelGroup> groupPixels(const Difference&);

} // namespace yarte::validate
