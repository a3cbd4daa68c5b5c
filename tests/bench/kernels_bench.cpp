// Time per ray of what tracing consists of, by lane width: the intersection kernel of each shape, Phong's
// power, and searches through a tree; the scalar code, whose bits they all give, beside them.
//
// Names are WORK/TARGET/RAYS IN A PACKET; the counter `perRay` is in seconds.
#include <benchmark/benchmark.h>

#include <string>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tests/bench/kernels_bench.cpp"
#define HWY_DISABLED_TARGETS (HWY_AVX3_DL | HWY_SSSE3)
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#define YARTE_PRECISION inDouble
#include "tests/bench/kernel_cases.h"
#include "yarte/trace/lanes/power-inl.h"
#include "yarte/trace/lanes/shadows-inl.h"

#ifndef KERNELS_BENCH_COUNTER
#define KERNELS_BENCH_COUNTER
namespace yarte::bench {
inline void countRays(benchmark::State& state, std::size_t perIteration) {
    using benchmark::Counter;
    state.counters["perRay"] =
        Counter(static_cast<double>(perIteration), Counter::kIsIterationInvariantRate | Counter::kInvert);
}
} // namespace yarte::bench
#endif

HWY_BEFORE_NAMESPACE();
namespace yarte::trace::HWY_NAMESPACE {
namespace {

using namespace inDouble;

struct Packet {
    RayPacket rays;
    ShearPacket shear;
};

/// The last packet is filled up with its last ray.
std::vector<Packet> packetsOf(const std::vector<Ray>& rays) {
    std::vector<Packet> packets((rays.size() + lanes - 1) / lanes);
    for (std::size_t i = 0; i < packets.size() * lanes; ++i) {
        const Ray& ray = rays[std::min(i, rays.size() - 1)];
        RayPacket& packet = packets[i / lanes].rays;
        const std::size_t lane = i % lanes;
        packet.ox[lane] = ray.origin.x, packet.oy[lane] = ray.origin.y, packet.oz[lane] = ray.origin.z;
        packet.dx[lane] = ray.direction.x, packet.dy[lane] = ray.direction.y,
        packet.dz[lane] = ray.direction.z;
        packet.from[lane] = laneOf(ray.from.element.index),
        packet.inside[lane] = ray.from.side == Side::inside ? 1 : 0;
    }
    for (Packet& packet : packets) packet.shear.shearAlong(packet.rays, bench::faces());
    return packets;
}

/// Of a shape that shears its corners the kernel takes the packet's shear as done: it is once for all of
/// them.
template <class Shape>
void crossingsKernel(benchmark::State& state, const Shape& shape) {
    const std::vector<Packet> packets = packetsOf(bench::raysToShapes());
    const RoundingPacket rounding(packets[0].rays, bench::faces().rounding); // in double the same for all
    const V infinity = set(Bounds::infinity);
    alignas(64) double enter[lanes], leave[lanes];
    for (auto _ : state)
        for (const Packet& packet : packets) {
            for (std::size_t at = 0; at < lanes; at += half) {
                const CrossingLanes c =
                    crossings(shape, Lines{packet.rays, packet.shear, rounding}, at, infinity);
                store(select(c.enters, c.enter, infinity), enter + at);
                store(select(c.leaves, c.leave, infinity), leave + at);
            }
            benchmark::DoNotOptimize(enter), benchmark::DoNotOptimize(leave);
        }
    bench::countRays(state, packets.size() * lanes);
}

void shearKernel(benchmark::State& state) {
    const std::vector<Packet> packets = packetsOf(bench::raysToShapes());
    ShearPacket shear;
    for (auto _ : state)
        for (const Packet& packet : packets) {
            shear.shearAlong(packet.rays, bench::faces());
            benchmark::DoNotOptimize(shear);
        }
    bench::countRays(state, packets.size() * lanes);
}

void powerKernel(benchmark::State& state) {
    const std::vector<double>& values = bench::cosines();
    alignas(64) double result[half];
    for (auto _ : state)
        for (std::size_t i = 0; i < values.size(); i += half) {
            store(power(hn::LoadU(D(), &values[i]), set(bench::phongExponent)), result);
            benchmark::DoNotOptimize(result);
        }
    bench::countRays(state, values.size());
}

void nearestSearch(benchmark::State& state, const bench::Field& field) {
    const std::vector<Packet> packets = packetsOf(field.rays);
    HitPacket hits;
    for (auto _ : state)
        for (const Packet& packet : packets) {
            nearestHits(*field.world, packet.rays, hits);
            benchmark::DoNotOptimize(hits);
        }
    bench::countRays(state, packets.size() * lanes);
}

void shadowSearch(benchmark::State& state, const bench::Field& field, const LightBuffer& buffer) {
    const std::vector<Packet> packets = packetsOf(field.shadow);
    const V3 light = spread(field.world->lights[0].position);
    ShadowPacket shadow;
    ElementId blocker;
    for (auto _ : state)
        for (const Packet& packet : packets) {
            for (std::size_t at = 0; at < lanes; at += half) {
                const V3 way = light - packet.rays.origin(at);
                store(hn::Sqrt(dot(way, way)), shadow.distance + at);
                store(set(0), shadow.blocked + at);
            }
            findShadows(*field.world, packet.rays, buffer, shadow, blocker);
            benchmark::DoNotOptimize(shadow);
        }
    bench::countRays(state, packets.size() * lanes);
}

std::string named(const std::string& work) {
    return work + '/' + hwy::TargetName(HWY_TARGET) + '/' + std::to_string(lanes);
}

void registerKernels() {
    using benchmark::RegisterBenchmark;
    bench::forEachShape([](const char* name, const auto& shape) {
        RegisterBenchmark(named(name).c_str(),
                          [shape](benchmark::State& state) { crossingsKernel(state, shape); });
    });
    const FaceTable& table = bench::faces();
    const TriangleShape triangle{table.vertices.data(), table.corners.data(), table.rounding};
    RegisterBenchmark(named("triangle").c_str(),
                      [triangle](benchmark::State& state) { crossingsKernel(state, triangle); });
    RegisterBenchmark(named("shear of a packet").c_str(), shearKernel);
    RegisterBenchmark(named("power").c_str(), powerKernel);
    bench::forEachField([](const std::string& name, auto& field) {
        RegisterBenchmark(named("nearest hit, " + name).c_str(),
                          [&field](benchmark::State& state) { nearestSearch(state, field()); });
        RegisterBenchmark(named("shadow, " + name).c_str(),
                          [&field](benchmark::State& state) { shadowSearch(state, field(), {}); });
        RegisterBenchmark(named("shadow by light buffer, " + name).c_str(),
                          [&field](benchmark::State& state) {
                              const LightBuffer& buffer = field().world->lightBuffers[0];
                              if (buffer.empty())
                                  state.SkipWithError("no light buffer is made of this");
                              else
                                  shadowSearch(state, field(), buffer);
                          });
    });
}

} // namespace
} // namespace yarte::trace::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace yarte::trace {
namespace {

HWY_EXPORT(registerKernels);

template <class Shape>
void crossingsReference(benchmark::State& state, const Shape& shape) {
    const std::vector<Ray> rays = bench::raysToShapes();
    for (auto _ : state)
        for (const Ray& ray : rays) benchmark::DoNotOptimize(crossings(shape, ray));
    bench::countRays(state, rays.size());
}

void powerReference(benchmark::State& state) {
    for (auto _ : state)
        for (const double x : bench::cosines()) benchmark::DoNotOptimize(power(x, bench::phongExponent));
    bench::countRays(state, bench::cosines().size());
}

void nearestReference(benchmark::State& state, const bench::Field& field) {
    for (auto _ : state)
        for (const Ray& ray : field.rays) benchmark::DoNotOptimize(nearestHit(*field.world, ray));
    bench::countRays(state, field.rays.size());
}

void shadowReference(benchmark::State& state, const bench::Field& field) {
    const Vec3 light = field.world->lights[0].position;
    for (auto _ : state)
        for (const Ray& ray : field.shadow)
            benchmark::DoNotOptimize(transmittance(*field.world, ray, length(light - ray.origin)));
    bench::countRays(state, field.shadow.size());
}

void registerReferences() {
    using benchmark::RegisterBenchmark;
    const auto named = [](const std::string& work) { return work + "/scalar/1"; };
    bench::forEachShape([&](const char* name, const auto& shape) {
        RegisterBenchmark(named(name).c_str(),
                          [shape](benchmark::State& state) { crossingsReference(state, shape); });
    });
    const FaceShape triangle{bench::faces(), bench::faces().faces[0]};
    RegisterBenchmark(named("triangle").c_str(),
                      [triangle](benchmark::State& state) { crossingsReference(state, triangle); });
    RegisterBenchmark(named("power").c_str(), powerReference);
    bench::forEachField([&](const std::string& name, auto& field) {
        RegisterBenchmark(named("nearest hit, " + name).c_str(),
                          [&field](benchmark::State& state) { nearestReference(state, field()); });
        RegisterBenchmark(named("shadow, " + name).c_str(),
                          [&field](benchmark::State& state) { shadowReference(state, field()); });
    });
}

} // namespace
} // namespace yarte::trace

int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    yarte::trace::registerReferences();
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
        hwy::SetSupportedTargetsForTest(target);
        HWY_DYNAMIC_DISPATCH(yarte::trace::registerKernels)();
        hwy::SetSupportedTargetsForTest(0);
    }
    benchmark::RunSpecifiedBenchmarks();
}
#endif
