#include "yarte/trace/lanes/lanes.h"

#include "yarte/trace/lanes/targets.h"

#include <algorithm>
#include <stdexcept>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "yarte/trace/lanes/lanes.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#define YARTE_PRECISION inDouble
#include "yarte/trace/lanes/whitted-inl.h"

HWY_BEFORE_NAMESPACE();
namespace yarte::trace::HWY_NAMESPACE {

void renderTileInDouble(const World& world, Tile tile, Colour* pixels, std::size_t stride, RayCounts& counts,
                        TraceTimes* times) {
    inDouble::renderTile(world, tile, pixels, stride, counts, times);
}
void cameraHitsInDouble(const World& world, Tile tile, CameraHit* to) {
    inDouble::cameraHits(world, tile, to);
}
// Of lanes_float.cpp.
void renderTileInFloat(const World& world, Tile tile, Colour* pixels, std::size_t stride, RayCounts& counts,
                       TraceTimes* times);
void cameraHitsInFloat(const World& world, Tile tile, CameraHit* to);

} // namespace yarte::trace::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace yarte::trace {
namespace {

/// The kernels of one instruction set.
struct Target {
    const char* name; ///< as Highway calls it, or "baseline"
    decltype(&HWY_STATIC_DISPATCH(renderTileInDouble)) renderInDouble, renderInFloat;
    decltype(&HWY_STATIC_DISPATCH(cameraHitsInDouble)) hitsInDouble, hitsInFloat;
    bool (*runsHere)();
};

// Highway would choose as well, but its library measures the clock when a program starts, for longer than a
// small picture takes. What a target needs is listed in hwy/ops/set_macros-inl.h.
#if HWY_ARCH_X86
bool hasSse4() {
    return __builtin_cpu_supports("sse4.2") && __builtin_cpu_supports("pclmul") &&
           __builtin_cpu_supports("aes");
}
bool hasAvx2() {
    return hasSse4() && __builtin_cpu_supports("avx2") && __builtin_cpu_supports("bmi") &&
           __builtin_cpu_supports("bmi2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("f16c");
}
bool hasAvx3() {
    return hasAvx2() && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
           __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw");
}
#endif
bool always() { return true; }

/// Best first.
constexpr Target targets[] = {
#if HWY_TARGETS & HWY_AVX3
    {"AVX3", &N_AVX3::renderTileInDouble, &N_AVX3::renderTileInFloat, &N_AVX3::cameraHitsInDouble,
     &N_AVX3::cameraHitsInFloat, hasAvx3},
#endif
#if HWY_TARGETS & HWY_AVX2
    {"AVX2", &N_AVX2::renderTileInDouble, &N_AVX2::renderTileInFloat, &N_AVX2::cameraHitsInDouble,
     &N_AVX2::cameraHitsInFloat, hasAvx2},
#endif
#if HWY_TARGETS & HWY_SSE4
    {"SSE4", &N_SSE4::renderTileInDouble, &N_SSE4::renderTileInFloat, &N_SSE4::cameraHitsInDouble,
     &N_SSE4::cameraHitsInFloat, hasSse4},
#endif
    {"baseline", &HWY_STATIC_DISPATCH(renderTileInDouble), &HWY_STATIC_DISPATCH(renderTileInFloat),
     &HWY_STATIC_DISPATCH(cameraHitsInDouble), &HWY_STATIC_DISPATCH(cameraHitsInFloat), always},
};

const Target* best() {
    return std::ranges::find_if(targets, [](const Target& target) { return target.runsHere(); });
}

const Target* chosen = best();

} // namespace

void renderTileInLanes(const World& world, Tile tile, Colour* pixels, std::size_t stride, RayCounts& counts,
                       TraceTimes* times) {
    const auto render =
        world.precision == Precision::inDouble ? chosen->renderInDouble : chosen->renderInFloat;
    render(world, tile, pixels, stride, counts, times);
}

void cameraHitsInLanes(const World& world, Tile tile, CameraHit* to) {
    const auto hits = world.precision == Precision::inDouble ? chosen->hitsInDouble : chosen->hitsInFloat;
    hits(world, tile, to);
}

std::vector<std::string> laneTargets() {
    std::vector<std::string> names;
    for (const Target& target : targets)
        if (target.runsHere()) names.emplace_back(target.name);
    return names;
}

void forceLaneTarget(const std::string& name) {
    chosen = best();
    for (const Target& target : targets)
        if (name == target.name && target.runsHere()) chosen = &target;
}

} // namespace yarte::trace
#endif
