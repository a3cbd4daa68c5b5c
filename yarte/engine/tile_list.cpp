#include "yarte/engine/tile_list.h"

#include <algorithm>
#include <cassert>

namespace yarte {

namespace {

std::size_t tilesAlong(int length, int side) { return static_cast<std::size_t>((length - 1) / side + 1); }

} // namespace

TileList::TileList(Tile region, int side)
    : region_(region), side_(side), columns_(tilesAlong(region.width(), side_)),
      rows_(tilesAlong(region.height(), side_)) {
    assert(region.width() > 0 && region.height() > 0 && side > 0);
}

Tile TileList::operator[](std::size_t index) const {
    const int x = region_.x0 + static_cast<int>(index % columns_) * side_;
    const int y = region_.y0 + static_cast<int>(index / columns_) * side_;
    // Compared as lengths: x + side_ could pass the largest int at the edge of the largest image.
    return {x, y, x + std::min(side_, region_.x1 - x), y + std::min(side_, region_.y1 - y)};
}

int suitableTileSide(Tile region, int workers) {
    constexpr int large = 32, small = 16;
    const bool areEnough = TileList(region, large).size() >= 16 * static_cast<std::size_t>(workers);
    return workers == 1 || areEnough ? large : small;
}

} // namespace yarte
