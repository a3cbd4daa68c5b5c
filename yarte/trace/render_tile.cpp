#include "yarte/trace/render_tile.h"

#include "yarte/trace/lanes/lanes.h"
#include "yarte/trace/whitted.h"

#include <ctime>

namespace yarte {

namespace {

/// The time that this thread has had a core.
double threadSeconds() {
    timespec t{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

} // namespace

void renderTile(const World& world, Tile tile, Colour* pixels, std::size_t stride, RayCounts& counts) {
    trace::renderTileInLanes(world, tile, pixels, stride, counts, nullptr);
}

void renderTileTimed(const World& world, Tile tile, Colour* pixels, std::size_t stride, RayCounts& counts,
                     TraceTimes& times) {
    const double begin = threadSeconds();
    trace::renderTileInLanes(world, tile, pixels, stride, counts, &times);
    times.seconds += threadSeconds() - begin;
}

void renderTileReference(const World& world, Tile tile, Colour* pixels, std::size_t stride,
                         RayCounts& counts) {
    trace::Whitted whitted(world);
    for (int y = tile.y0; y < tile.y1; ++y) {
        for (int x = tile.x0; x < tile.x1; ++x)
            pixels[x - tile.x0] = whitted.colour(world.camera.through(x, y), counts);
        pixels += stride;
    }
}

} // namespace yarte
