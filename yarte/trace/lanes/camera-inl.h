// Camera rays of a packet, and what they meet.
#if defined(YARTE_TRACE_LANES_CAMERA_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef YARTE_TRACE_LANES_CAMERA_INL_H
#undef YARTE_TRACE_LANES_CAMERA_INL_H
#else
#define YARTE_TRACE_LANES_CAMERA_INL_H
#endif

#include "yarte/trace/camera_hits.h"
#include "yarte/trace/lanes/shading-inl.h"

HWY_BEFORE_NAMESPACE();
namespace yarte::trace::HWY_NAMESPACE::YARTE_PRECISION {

/// CameraRays::through for a vector of pixels.
HWY_INLINE V3 cameraDirections(const CameraRays& camera, V x, V y) {
    const V u = (x + set(0.5)) / set(camera.width) - set(0.5);
    const V v = set(0.5) - (y + set(0.5)) / set(camera.height);
    return normalised(spread(camera.forward) + spread(camera.right) * u + spread(camera.up) * v);
}

/// Pixels [x, x + lanes) of a row, of which the first `count` are wanted.
HWY_NOINLINE void packetHits(const World& world, int x, int y, std::size_t count, CameraHit* to) {
    RayPacket rays;
    HitPacket hits;
    PointPacket points;
    alignas(64) Scalar columns[lanes];
    for (std::size_t i = 0; i < lanes; ++i) columns[i] = static_cast<Scalar>(x + static_cast<int>(i));
    for (std::size_t at = 0; at < lanes; at += half) {
        rays.setOrigin(at, spread(world.camera.position));
        rays.setDirection(at, cameraDirections(world.camera, load(columns + at), set(y)));
        store(set(noElement), rays.from + at), store(set(0), rays.inside + at);
    }
    nearestHits(world, rays, hits);
    if (!hits.isEmpty()) describeHits(world, rays, hits, points);
    for (std::size_t i = 0; i < count; ++i) {
        to[i] = {};
        if (hits.element[i] == noElement) continue;
        to[i] = {static_cast<int>(world.bodyOf({idIn(hits.element[i])}).index), hits.t[i],
                 Vec3{points.nx[i], points.ny[i], points.nz[i]}};
    }
}

inline void cameraHits(const World& world, Tile tile, CameraHit* to) {
    for (int y = tile.y0; y < tile.y1; ++y)
        for (int x = tile.x0; x < tile.x1; x += static_cast<int>(lanes)) {
            const std::size_t count = std::min(lanes, static_cast<std::size_t>(tile.x1 - x));
            packetHits(world, x, y, count, to);
            to += count;
        }
}

} // namespace yarte::trace::HWY_NAMESPACE::YARTE_PRECISION
HWY_AFTER_NAMESPACE();

#endif
