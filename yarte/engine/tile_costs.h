// TileCosts: what rendering a tile cost.
#pragma once

#include "yarte/trace/render_tile.h"

namespace yarte {

/// Its rays, and times where somebody measured them.
struct TileCosts : RayCounts {
    TraceTimes times;
    TileCosts& operator+=(const TileCosts& c) {
        RayCounts::operator+=(c);
        times += c.times;
        return *this;
    }
    friend bool operator==(const TileCosts&, const TileCosts&) = default;
};

} // namespace yarte
