// Framebuffer: the pixels of a region of the image, gathered from those who render its tiles.
#pragma once

#include "yarte/base/image.h"
#include "yarte/engine/shared_file.h"
#include "yarte/trace/render_tile.h"

#include <cstddef>
#include <vector>

namespace yarte {

/// The picture lies in a SharedFile, tile after tile, and is never in memory as a whole a second time: who
/// writes it to a file needs a strip of tiles at a time.
class Framebuffer {
public:
    /// Black. Throws RenderError if the machine has not the memory, before any is taken, or std::bad_alloc.
    Framebuffer(Tile region, int tileSide);

    Tile region() const { return region_; }

    /// Takes a tile's pixels, row after row. Called by several processes or threads at once for different
    /// tiles. Throws RenderError.
    void put(Tile, const Colour* tilePixels) const;

    /// A tile that was put. Throws RenderError.
    void get(Tile, Colour* tilePixels) const;

    /// What was put; for one reader. Its rows throw RenderError.
    ImageRows rows();

private:
    const Colour* row(int y);
    void loadStrip(int strip);
    std::size_t offsetOf(Tile) const;
    std::size_t width() const { return static_cast<std::size_t>(region_.width()); }

    Tile region_;
    int tileSide_;
    SharedFile tiles_;
    // The strip that was asked for last, and a tile of it.
    std::vector<Colour> strip_, tile_;
    int loadedStrip_ = -1;
};

} // namespace yarte
