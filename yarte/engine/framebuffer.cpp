#include "yarte/engine/framebuffer.h"

#include "yarte/engine/memory_limit.h"
#include "yarte/engine/render_error.h"
#include "yarte/engine/tile_list.h"

#include <algorithm>
#include <type_traits>
#include <vector>

namespace yarte {

// The mapping's zeros are black pixels: nothing is constructed, so that each page is first written by who
// renders it.
static_assert(std::is_trivially_copyable_v<Colour> && std::is_trivially_destructible_v<Colour>);

namespace {

std::size_t sizeOf(Tile tile) {
    return static_cast<std::size_t>(tile.width()) * static_cast<std::size_t>(tile.height()) * sizeof(Colour);
}

MappedMemory mapPixels(Tile region) {
    if (const auto why = imageTooLarge(region.width(), region.height(), memoryLimit()))
        throw RenderError(*why);
    return mapPrivateMemory(sizeOf(region));
}

} // namespace

Framebuffer::Framebuffer(Tile region, int tileSide, Renderers renderers)
    : region_(region), tileSide_(tileSide), memory_(mapPixels(region)) {
    if (renderers == Renderers::processes) tiles_ = std::make_unique<SharedFile>(sizeOf(region));
}

void Framebuffer::put(Tile tile, const Colour* tilePixels) const {
    if (tiles_)
        tiles_->write(offsetOf(tile), tilePixels, sizeOf(tile));
    else
        copyToRows(tile, tilePixels);
}

/// A strip of tiles takes up the bytes that its rows do.
std::size_t Framebuffer::offsetOf(Tile tile) const {
    return (static_cast<std::size_t>(tile.y0 - region_.y0) * width() +
            static_cast<std::size_t>(tile.x0 - region_.x0) * static_cast<std::size_t>(tile.height())) *
           sizeof(Colour);
}

void Framebuffer::copyToRows(Tile tile, const Colour* tilePixels) const {
    for (int y = tile.y0; y < tile.y1; ++y, tilePixels += tile.width())
        std::copy_n(tilePixels, tile.width(), row(y) + (tile.x0 - region_.x0));
}

void Framebuffer::gather() {
    if (!tiles_) return;
    const TileList tiles(region_, tileSide_);
    std::vector<Colour> pixelsOfTile;
    for (std::size_t i = 0; i < tiles.size(); ++i) {
        pixelsOfTile.resize(sizeOf(tiles[i]) / sizeof(Colour));
        tiles_->take(offsetOf(tiles[i]), pixelsOfTile.data(), sizeOf(tiles[i]));
        copyToRows(tiles[i], pixelsOfTile.data());
    }
    tiles_.reset();
}

} // namespace yarte
