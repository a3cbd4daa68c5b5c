// Framebuffer: the pixels of a region of the image, shared with the processes that render them.
#pragma once

#include "yarte/base/image.h"
#include "yarte/engine/shared_memory.h"
#include "yarte/trace/render_tile.h"

#include <cstddef>

namespace yarte {

class Framebuffer {
public:
    /// Black. Throws RenderError if the machine has not the memory, before any is taken.
    explicit Framebuffer(Tile region);

    Tile region() const { return region_; }
    ImageView view() const { return {region_.width(), region_.height(), pixels()}; }

    /// Pixels from one row to the next.
    std::size_t stride() const { return static_cast<std::size_t>(region_.width()); }
    /// The first pixel of a tile of the region.
    Colour* at(Tile) const;

private:
    Colour* pixels() const { return static_cast<Colour*>(memory_.get()); }

    Tile region_;
    SharedMemory memory_;
};

} // namespace yarte
