#include "yarte/engine/framebuffer.h"

#include "yarte/engine/memory_limit.h"
#include "yarte/engine/render_error.h"
#include "yarte/engine/tile_list.h"

#include <algorithm>
#include <type_traits>
#include <vector>

namespace yarte {

// Pixels are written to the file as they are, and its zeros are black ones.
static_assert(std::is_trivially_copyable_v<Colour>);

namespace {

std::size_t sizeOf(Tile tile) {
    return static_cast<std::size_t>(tile.width()) * static_cast<std::size_t>(tile.height()) * sizeof(Colour);
}

/// Also asks whether the machine has the memory.
std::size_t sizeOfPicture(Tile region) {
    if (const auto why = imageTooLarge(region.width(), region.height(), memoryLimit()))
        throw RenderError(*why);
    return sizeOf(region);
}

} // namespace

Framebuffer::Framebuffer(Tile region, int tileSide)
    : region_(region), tileSide_(tileSide), tiles_(sizeOfPicture(region)) {}

void Framebuffer::put(Tile tile, const Colour* tilePixels) const {
    tiles_.write(offsetOf(tile), tilePixels, sizeOf(tile));
}

void Framebuffer::get(Tile tile, Colour* tilePixels) const {
    tiles_.read(offsetOf(tile), tilePixels, sizeOf(tile));
}

/// A strip of tiles takes up the bytes that its rows do.
std::size_t Framebuffer::offsetOf(Tile tile) const {
    return (static_cast<std::size_t>(tile.y0 - region_.y0) * width() +
            static_cast<std::size_t>(tile.x0 - region_.x0) * static_cast<std::size_t>(tile.height())) *
           sizeof(Colour);
}

ImageRows Framebuffer::rows() {
    return {region_.width(), region_.height(), [this](int y) { return row(y); }};
}

const Colour* Framebuffer::row(int y) {
    if (y / tileSide_ != loadedStrip_) loadStrip(y / tileSide_);
    return &strip_[static_cast<std::size_t>(y % tileSide_) * width()];
}

void Framebuffer::loadStrip(int strip) {
    const TileList tiles(region_, tileSide_);
    const std::size_t first = static_cast<std::size_t>(strip) * tiles.columns();
    strip_.resize(width() * static_cast<std::size_t>(tiles[first].height()));
    for (std::size_t i = first; i < first + tiles.columns(); ++i) {
        const Tile tile = tiles[i];
        tile_.resize(sizeOf(tile) / sizeof(Colour));
        get(tile, tile_.data());
        const Colour* from = tile_.data();
        for (std::size_t y = 0; y < static_cast<std::size_t>(tile.height()); ++y, from += tile.width())
            std::copy_n(from, tile.width(),
                        &strip_[y * width() + static_cast<std::size_t>(tile.x0 - region_.x0)]);
    }
    loadedStrip_ = strip;
}

} // namespace yarte
