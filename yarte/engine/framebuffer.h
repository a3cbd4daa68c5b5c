// Framebuffer: the pixels of a region of the image, gathered from those who render its tiles.
#pragma once

#include "yarte/base/image.h"
#include "yarte/engine/mapped_memory.h"
#include "yarte/engine/shared_file.h"
#include "yarte/trace/render_tile.h"

#include <cstddef>
#include <memory>

namespace yarte {

class Framebuffer {
public:
    enum class Renderers { threads, processes }; ///< threads: of this process
    /// Black. Throws RenderError if the machine has not the memory, before any is taken, or std::bad_alloc.
    Framebuffer(Tile region, int tileSide, Renderers);

    Tile region() const { return region_; }

    /// Takes a tile's pixels, row after row. Called by several renderers at once for different tiles.
    void put(Tile, const Colour* tilePixels) const;
    /// Brings together what processes have put; to be called when all have, before view(). Throws
    /// RenderError.
    void gather();

    ImageView view() const { return {region_.width(), region_.height(), pixels()}; }

private:
    Colour* pixels() const { return static_cast<Colour*>(memory_.get()); }
    /// The first pixel of row `y` of the image.
    Colour* row(int y) const { return pixels() + static_cast<std::size_t>(y - region_.y0) * width(); }
    std::size_t width() const { return static_cast<std::size_t>(region_.width()); }
    void copyToRows(Tile, const Colour* tilePixels) const;
    std::size_t offsetOf(Tile) const;

    Tile region_;
    int tileSide_;
    MappedMemory memory_;
    std::unique_ptr<SharedFile> tiles_; ///< of processes: tile after tile
};

} // namespace yarte
