#include "yarte/engine/framebuffer.h"

#include "yarte/engine/memory_limit.h"
#include "yarte/engine/render_error.h"

#include <type_traits>

namespace yarte {

// The mapping's zeros are black pixels: nothing is constructed, so that each page is first written by who
// renders it.
static_assert(std::is_trivially_copyable_v<Colour> && std::is_trivially_destructible_v<Colour>);

namespace {

SharedMemory mapPixels(Tile region) {
    if (const auto why = imageTooLarge(region.width(), region.height(), memoryLimit()))
        throw RenderError(*why);
    return mapSharedMemory(static_cast<std::size_t>(region.width()) *
                           static_cast<std::size_t>(region.height()) * sizeof(Colour));
}

} // namespace

Framebuffer::Framebuffer(Tile region) : region_(region), memory_(mapPixels(region)) {}

Colour* Framebuffer::at(Tile tile) const {
    return pixels() + static_cast<std::size_t>(tile.y0 - region_.y0) * stride() +
           static_cast<std::size_t>(tile.x0 - region_.x0);
}

} // namespace yarte
