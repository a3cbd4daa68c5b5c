// renderTile: the pixels of a rectangle of the image. All that the engine needs to know of the tracer.
#pragma once

#include "yarte/base/colour.h"
#include "yarte/scene/scene.h"

#include <cstddef>
#include <cstdint>
#include <memory>

namespace yarte {

/// What rays meet: immutable, built once from a scene, shared by threads and (copy-on-write) by forked
/// processes.
class World;

struct WorldDeleter {
    void operator()(const World*) const;
};
using WorldPtr = std::unique_ptr<const World, WorldDeleter>;

/// What renderTile computes in.
enum class Precision {
    inDouble, ///< the reference
    inFloat,  ///< faster, for pictures that are only looked at
};

/// `resolution` is that of the whole image (the scene's own, or what the user asked for instead). A scene
/// that float cannot hold is built for double in any case; see precisionOf.
WorldPtr buildWorld(const Scene&, Resolution resolution, Precision = Precision::inDouble);

Precision precisionOf(const World&);

/// Pixels [x0, x1) x [y0, y1) of the image, row 0 on top.
struct Tile {
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
    int width() const { return x1 - x0; }
    int height() const { return y1 - y0; }
    friend bool operator==(const Tile&, const Tile&) = default;
};

/// Rays traced, by kind.
struct RayCounts {
    std::uint64_t camera = 0, shadow = 0, reflected = 0, transmitted = 0;
    RayCounts& operator+=(const RayCounts& c) {
        camera += c.camera, shadow += c.shadow, reflected += c.reflected, transmitted += c.transmitted;
        return *this;
    }
    friend bool operator==(const RayCounts&, const RayCounts&) = default;
};

/// Where the time of tracing goes, from a sample of the blocks of pixels that are traced together.
struct TraceTimes {
    double seconds = 0; ///< of all tiles, measured
    // In the blocks of the sample, in ticks of some clock: all of them, and those of searching for what
    // camera rays meet, what shadow rays meet, what all other rays meet. What is left is shading.
    std::uint64_t sampled = 0, camera = 0, shadow = 0, secondary = 0;

    /// The seconds that belong to so many ticks; NaN if nothing was sampled.
    double secondsOf(std::uint64_t ticks) const {
        return seconds * static_cast<double>(ticks) / static_cast<double>(sampled);
    }
    TraceTimes& operator+=(const TraceTimes& t) {
        seconds += t.seconds, sampled += t.sampled;
        camera += t.camera, shadow += t.shadow, secondary += t.secondary;
        return *this;
    }
    friend bool operator==(const TraceTimes&, const TraceTimes&) = default;
};

/// Writes the tile's linear colours to `pixels`, whose rows are `stride` pixels apart, and adds to `counts`.
/// A pixel depends on the world and its own place alone: never on the tile, the process or the thread.
void renderTile(const World&, Tile, Colour* pixels, std::size_t stride, RayCounts& counts);

/// The same, and measures: adds to `times`.
void renderTileTimed(const World&, Tile, Colour* pixels, std::size_t stride, RayCounts& counts,
                     TraceTimes& times);

/// The same as renderTile, ray by ray in plain code and always in double: the reference that renderTile in
/// double equals to the last bit.
void renderTileReference(const World&, Tile, Colour* pixels, std::size_t stride, RayCounts& counts);

} // namespace yarte
