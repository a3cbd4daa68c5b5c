// TileList: the rectangles that cover a region of the image, row by row.
#pragma once

#include "yarte/trace/render_tile.h"

#include <cstddef>

namespace yarte {

class TileList {
public:
    /// Squares of `side` pixels, smaller ones at the right and lower edges. The region is not empty, side
    /// >= 1.
    TileList(Tile region, int side);

    std::size_t size() const { return columns_ * rows_; }
    std::size_t columns() const { return columns_; } ///< tiles side by side
    Tile operator[](std::size_t index) const;

private:
    Tile region_;
    int side_;
    std::size_t columns_, rows_;
};

/// The side of tiles that suits so many workers (>= 0) best: 32 pixels, whose dealing costs little, or 16
/// where each worker would get fewer than 16 of the large ones, and too many wait for the last. Measured by
/// ci/bench balance.
int suitableTileSide(Tile region, int workers);

} // namespace yarte
