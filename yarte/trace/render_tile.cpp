#include "yarte/trace/render_tile.h"

#include "yarte/trace/camera_hits.h"
#include "yarte/trace/lanes/lanes.h"
#include "yarte/trace/whitted.h"

#include <chrono>

namespace yarte {

void renderTile(const World& world, Tile tile, Colour* pixels, std::size_t stride, RayCounts& counts) {
    trace::renderTileInLanes(world, tile, pixels, stride, counts, nullptr);
}

void renderTileTimed(const World& world, Tile tile, Colour* pixels, std::size_t stride, RayCounts& counts,
                     TraceTimes& times) {
    using Clock = std::chrono::steady_clock;
    const Clock::time_point begin = Clock::now();
    trace::renderTileInLanes(world, tile, pixels, stride, counts, &times);
    times.seconds += std::chrono::duration<double>(Clock::now() - begin).count();
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

std::vector<CameraHit> cameraHits(const World& world, Tile tile) {
    std::vector<CameraHit> hits(static_cast<std::size_t>(tile.width()) *
                                static_cast<std::size_t>(tile.height()));
    trace::cameraHitsInLanes(world, tile, hits.data());
    return hits;
}

} // namespace yarte
