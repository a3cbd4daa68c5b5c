// The kernels in float, for lanes.cpp.
#include "yarte/trace/lanes/targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "yarte/trace/lanes/lanes_float.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#define YARTE_PRECISION inFloat
#include "yarte/trace/lanes/whitted-inl.h"

HWY_BEFORE_NAMESPACE();
namespace yarte::trace::HWY_NAMESPACE {

void renderTileInFloat(const World& world, Tile tile, Colour* pixels, std::size_t stride, RayCounts& counts,
                       TraceTimes* times) {
    inFloat::renderTile(world, tile, pixels, stride, counts, times);
}
void cameraHitsInFloat(const World& world, Tile tile, CameraHit* to) { inFloat::cameraHits(world, tile, to); }

} // namespace yarte::trace::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
