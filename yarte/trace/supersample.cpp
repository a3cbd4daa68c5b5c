#include "yarte/trace/supersample.h"

#include <algorithm>
#include <vector>

namespace yarte {

namespace {

/// Adds up a pixel's samples, row by row; `stride` is that of the samples.
Colour mean(const Colour* first, int samples, std::size_t stride) {
    Colour sum;
    for (int y = 0; y < samples; ++y, first += stride)
        for (int x = 0; x < samples; ++x) sum += first[x];
    return sum * (1.0 / (samples * samples));
}

} // namespace

void supersample(int samples, Tile tile, Colour* pixels, std::size_t stride,
                 const std::function<void(Tile, Colour*, std::size_t)>& renderFine) {
    if (samples == 1) return renderFine(tile, pixels, stride);
    // A few pixels at a time, so that their samples stay in the cache.
    const int side = std::max(1, 64 / samples);
    std::vector<Colour> block;
    for (int y0 = tile.y0; y0 < tile.y1; y0 += side)
        for (int x0 = tile.x0; x0 < tile.x1; x0 += side) {
            const int x1 = std::min(x0 + side, tile.x1), y1 = std::min(y0 + side, tile.y1);
            const Tile part{x0 * samples, y0 * samples, x1 * samples, y1 * samples};
            const auto width = static_cast<std::size_t>(part.width());
            block.resize(width * static_cast<std::size_t>(part.height()));
            renderFine(part, block.data(), width);
            for (int y = y0; y < y1; ++y)
                for (int x = x0; x < x1; ++x)
                    pixels[static_cast<std::size_t>(y - tile.y0) * stride +
                           static_cast<std::size_t>(x - tile.x0)] =
                        mean(&block[static_cast<std::size_t>((y - y0) * samples) * width +
                                    static_cast<std::size_t>((x - x0) * samples)],
                             samples, width);
        }
}

} // namespace yarte
