#include "yarte/trace/lanes/lanes.h"

#include <algorithm>
#include <stdexcept>

// No gain over AVX3 and SSE4 for doubles, only compile time.
#define HWY_DISABLED_TARGETS (HWY_AVX3_DL | HWY_SSSE3)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "yarte/trace/lanes/lanes.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "yarte/trace/lanes/whitted-inl.h"

HWY_BEFORE_NAMESPACE();
namespace yarte::trace::HWY_NAMESPACE {

void renderTile(const World& world, Tile tile, Colour* pixels, std::size_t stride, RayCounts& counts) {
    if (world.isTinted)
        WhittedLanes<true>(world, counts).render(tile, pixels, stride);
    else
        WhittedLanes<false>(world, counts).render(tile, pixels, stride);
}

} // namespace yarte::trace::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace yarte::trace {

HWY_EXPORT(renderTile);

void renderTileInLanes(const World& world, Tile tile, Colour* pixels, std::size_t stride, RayCounts& counts) {
    HWY_DYNAMIC_DISPATCH(renderTile)(world, tile, pixels, stride, counts);
}

std::vector<std::string> laneTargets() {
    hwy::SetSupportedTargetsForTest(0);
    std::vector<std::string> names;
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets())
        names.push_back(hwy::TargetName(target));
    return names;
}

void forceLaneTarget(const std::string& name) {
    hwy::SetSupportedTargetsForTest(0);
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets())
        if (name == hwy::TargetName(target)) hwy::SetSupportedTargetsForTest(target);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

} // namespace yarte::trace
#endif
