// tile_costs SCENE WxH RUNS SHAPE...: what each tile of a picture of WxH pixels costs, for tiles of each
// SHAPE (WxH), one thread. Prints JSON: for each shape the seconds of all tiles, row by row, medians of RUNS
// passes over the picture; for square ones also "deal", the seconds that the engine takes for a tile that
// costs nothing: dealing it, gathering its pixels.
#include "yarte/engine/render.h"
#include "yarte/lang/pmf.h"
#include "yarte/lang/scene_reader.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

using namespace yarte;

namespace {

Resolution sizeIn(const char* text) {
    Resolution size{};
    if (std::sscanf(text, "%dx%d", &size.width, &size.height) != 2 || size.width < 1 || size.height < 1) {
        fmt::print(stderr, "tile_costs: expected WxH, got '{}'\n", text);
        std::exit(2);
    }
    return size;
}

double now(clockid_t clock) {
    timespec t{};
    clock_gettime(clock, &t);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

/// By the clock, which reads quickly, unless another program had the core meanwhile: then by the time that
/// this one had it.
template <class Work>
double secondsOf(const Work& work) {
    const double ownBegin = now(CLOCK_THREAD_CPUTIME_ID), begin = now(CLOCK_MONOTONIC);
    work();
    const double end = now(CLOCK_MONOTONIC), ownEnd = now(CLOCK_THREAD_CPUTIME_ID);
    return std::min(end - begin, ownEnd - ownBegin);
}

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

std::vector<Tile> tilesOf(Resolution image, Resolution shape) {
    std::vector<Tile> tiles;
    for (int y = 0; y < image.height; y += shape.height)
        for (int x = 0; x < image.width; x += shape.width)
            tiles.push_back(
                {x, y, std::min(x + shape.width, image.width), std::min(y + shape.height, image.height)});
    return tiles;
}

/// The tiles of one shape, and what each took in every pass.
struct Tiling {
    std::string name;
    Resolution shape;
    std::vector<Tile> tiles;
    std::vector<std::vector<double>> seconds;
    std::vector<double> dealing; ///< a tile, if it is square

    Tiling(std::string given, Resolution image)
        : name(std::move(given)), shape(sizeIn(name.c_str())), tiles(tilesOf(image, shape)),
          seconds(tiles.size()) {}

    void renderOnce(const World& world) {
        std::vector<Colour> pixels;
        RayCounts rays;
        for (std::size_t i = 0; i < tiles.size(); ++i) {
            const auto width = static_cast<std::size_t>(tiles[i].width());
            pixels.resize(width * static_cast<std::size_t>(tiles[i].height()));
            seconds[i].push_back(secondsOf([&] { renderTile(world, tiles[i], pixels.data(), width, rays); }));
        }
    }

    void dealOnce(Resolution image) {
        if (shape.width != shape.height) return;
        const RenderOptions options{{0, 0, image.width, image.height}, shape.width, RenderMode::serial};
        const auto nothing = [](Tile, Colour*, std::size_t, RayCounts&) {};
        const double all = secondsOf([&] { render(options, nothing, {}); });
        dealing.push_back(all / static_cast<double>(tiles.size()));
    }

    std::string json() const {
        std::vector<double> costs;
        std::transform(seconds.begin(), seconds.end(), std::back_inserter(costs), median);
        const std::string deal = dealing.empty() ? "" : fmt::format(", \"deal\": {:.9f}", median(dealing));
        return fmt::format("\"{}\": {{\"seconds\": [{:.9f}]{}}}", name, fmt::join(costs, ", "), deal);
    }
};

} // namespace

int main(int argc, char** argv) {
    if (argc < 5) {
        fmt::print(stderr, "usage: tile_costs SCENE WxH RUNS SHAPE...\n");
        return 2;
    }
    constexpr MeshFormat formats[] = {{".pmf", readPmf}};
    Sources sources;
    Diagnostics diagnostics;
    const auto scene = readScene(argv[1], {{}, formats}, sources, diagnostics);
    if (!scene) {
        fmt::print(stderr, "{}", format(diagnostics, sources, DiagnosticStyle::plain));
        return 1;
    }
    const Resolution image = sizeIn(argv[2]);
    const int runs = std::max(1, std::atoi(argv[3]));
    const WorldPtr world = buildWorld(*scene, image);
    std::vector<Tiling> tilings;
    for (int i = 4; i < argc; ++i) tilings.emplace_back(argv[i], image);
    for (int run = 0; run < runs; ++run) // in turn: a machine whose speed drifts affects all alike
        for (Tiling& tiling : tilings) {
            tiling.renderOnce(*world);
            tiling.dealOnce(image);
        }
    std::vector<std::string> parts;
    for (const Tiling& tiling : tilings) parts.push_back(tiling.json());
    fmt::print("{{{}}}\n", fmt::join(parts, ",\n"));
}
