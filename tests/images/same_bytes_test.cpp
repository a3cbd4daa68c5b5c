// What no pixel depends on: instruction set and lane width, tree, tiles, processes and threads. Every scene
// is rendered in all of these ways, and each must give the bytes of plain code that goes ray by ray.
#include "tests/support/scenes.h"

#include "yarte/engine/render.h"
#include "yarte/lang/pmf.h"
#include "yarte/lang/scene_reader.h"
#include "yarte/trace/lanes/lanes.h"
#include "yarte/trace/world.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <string>
#include <vector>

using namespace yarte;

namespace {

namespace fs = std::filesystem;

const fs::path scenesFolder = fs::path(YARTE_SOURCE_DIR) / "scenes";

std::vector<std::string> sceneNames() {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(scenesFolder))
        if (entry.is_directory()) names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
}

constexpr int width = 64, height = 48;
constexpr Tile image{0, 0, width, height};

struct Picture {
    std::vector<Colour> pixels = std::vector<Colour>(width * height);
    RayCounts rays;
};

testing::AssertionResult sameBytes(const Picture& got, const Picture& expected) {
    for (std::size_t i = 0; i < got.pixels.size(); ++i) {
        const Colour a = got.pixels[i], b = expected.pixels[i];
        if (std::memcmp(&a, &b, sizeof a) != 0)
            return testing::AssertionFailure()
                   << fmt::format("pixel ({}, {}) is {} {} {}, not {} {} {}", i % width, i / width, a.r, a.g,
                                  a.b, b.r, b.g, b.b);
    }
    if (got.rays == expected.rays) return testing::AssertionSuccess();
    return testing::AssertionFailure() << "the same pixels of other numbers of rays";
}

struct Shape {
    int width, height;
};
constexpr Shape whole{width, height};

Picture inTiles(const World& world, Shape tile, decltype(renderTile)& renderer) {
    Picture picture;
    for (int y = 0; y < height; y += tile.height)
        for (int x = 0; x < width; x += tile.width)
            renderer(world, {x, y, std::min(x + tile.width, width), std::min(y + tile.height, height)},
                     &picture.pixels[static_cast<std::size_t>(y * width + x)], width, picture.rays);
    return picture;
}

Picture inEngine(const World& world, RenderMode mode, int workers, int tileSide) {
    auto rendering = render({image, tileSide, mode, workers},
                            [&](Tile tile, Colour* pixels, std::size_t stride, RayCounts& rays) {
                                renderTile(world, tile, pixels, stride, rays);
                            },
                            {});
    Picture picture;
    picture.rays = rendering->rays;
    const ImageRows rows = rendering->framebuffer.rows();
    for (int y = 0; y < height; ++y)
        std::copy_n(rows.row(y), width, &picture.pixels[static_cast<std::size_t>(y * width)]);
    return picture;
}

class SameBytes : public testing::TestWithParam<std::string> {
protected:
    SameBytes() {
        constexpr MeshFormat formats[] = {{".pmf", readPmf}};
        Sources sources;
        Diagnostics diagnostics;
        Scene scene = readScene(scenesFolder / GetParam() / (GetParam() + ".yarte"), {{}, formats}, sources,
                                diagnostics)
                          .value();
        // Too few elements for a tree: small balls behind the camera make up the number.
        const Vec3 back = normalised(scene.camera.position - scene.camera.focus);
        for (int i = 1; (world_ = buildWorld(scene, {width, height}))->tree.empty(); ++i)
            test::add(scene, Sphere{scene.camera.position + 0.1 * i * back, 0.03}, test::matt({1, 1, 1}));
        withoutTree_ = *world_;
        withoutTree_.tree = {};
        expected_ = inTiles(*world_, whole, renderTileReference);
    }
    ~SameBytes() override { trace::forceLaneTarget(""); }

    WorldPtr world_;
    World withoutTree_;
    Picture expected_;
};

TEST_P(SameBytes, WithoutATree) {
    EXPECT_TRUE(sameBytes(inTiles(withoutTree_, whole, renderTileReference), expected_));
}

TEST_P(SameBytes, OnEveryInstructionSetInTilesOfAnyShapeWithATreeAndWithout) {
    for (const std::string& target : trace::laneTargets()) {
        trace::forceLaneTarget(target);
        for (const World* world : {world_.get(), static_cast<const World*>(&withoutTree_)})
            for (const Shape tile : {whole, Shape{16, 16}, {7, 7}, {13, 5}, {width, 1}})
                EXPECT_TRUE(sameBytes(inTiles(*world, tile, renderTile), expected_))
                    << target << (world == &withoutTree_ ? ", no tree" : "") << ", tiles of " << tile.width
                    << 'x' << tile.height;
    }
}

TEST_P(SameBytes, FromAnyNumberOfProcessesOrThreads) {
    for (const int tileSide : {32, 11}) {
        EXPECT_TRUE(sameBytes(inEngine(*world_, RenderMode::serial, 1, tileSide), expected_))
            << "serial, tiles of " << tileSide;
        for (const int workers : {1, 2, 5}) {
            EXPECT_TRUE(sameBytes(inEngine(*world_, RenderMode::processes, workers, tileSide), expected_))
                << workers << " processes, tiles of " << tileSide;
            EXPECT_TRUE(sameBytes(inEngine(*world_, RenderMode::threads, workers, tileSide), expected_))
                << workers << " threads, tiles of " << tileSide;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Scenes, SameBytes, testing::ValuesIn(sceneNames()),
                         [](const auto& scene) { return scene.param; });

} // namespace
