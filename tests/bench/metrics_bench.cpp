// The validator's metrics on two pictures of 1920x1080, one core. Goals: FLIP 300 ms, all others together 50
// ms.
#include "validate/compare.h"
#include "validate/flip.h"
#include "validate/metrics.h"

#include <benchmark/benchmark.h>
#include <cmath>
#include <random>

namespace {

using namespace yarte;
using namespace yarte::validate;

/// Smooth shapes with edges; the second differs a little everywhere and much in one place.
Picture picture(bool second) {
    Picture made{1920, 1080, {}};
    made.pixels.reserve(1920 * 1080);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> noise(-1e-5, 1e-5);
    for (int y = 0; y < made.height; ++y)
        for (int x = 0; x < made.width; ++x) {
            const double disc = std::hypot(x - 700.0, y - 500.0) < 300 ? 0.6 : 0.1;
            const double wave = 0.5 + 0.4 * std::sin(x / 40.0) * std::cos(y / 25.0);
            Colour c{disc, wave, 0.5 * disc + 0.3 * wave};
            if (second) c = c + Colour{noise(random), noise(random), noise(random)};
            if (second && x > 1500 && y > 900) c = c * 0.5;
            made.pixels.push_back(c);
        }
    return made;
}

const Picture& a() {
    static const Picture made = picture(false);
    return made;
}
const Picture& b() {
    static const Picture made = picture(true);
    return made;
}

void flip(benchmark::State& state) {
    for (auto _ : state) benchmark::DoNotOptimize(flipMap(a().view(), b().view()));
}
BENCHMARK(flip)->Unit(benchmark::kMillisecond)->MinTime(3);

void otherMetrics(benchmark::State& state) {
    for (auto _ : state) {
        checkFinite({"a", a()});
        checkFinite({"b", b()});
        benchmark::DoNotOptimize(maxAbs(a().view(), b().view()));
        benchmark::DoNotOptimize(rmse(a().view(), b().view()));
        benchmark::DoNotOptimize(pixelsOver(a().view(), b().view(), 4.0 / 65535));
    }
}
BENCHMARK(otherMetrics)->Unit(benchmark::kMillisecond)->MinTime(2);

} // namespace
