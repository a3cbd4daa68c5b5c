// Rendering with invented tile functions: what the engine promises does not depend on the tracer.
#include "yarte/engine/render.h"

#include "yarte/engine/shared_memory.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstring>
#include <functional>
#include <new>
#include <random>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <sys/wait.h>
#include <unistd.h>

namespace yarte {
namespace {

using namespace std::chrono_literals;

/// A pixel that depends on its place alone, with all bits of the doubles in use.
Colour pixelAt(int x, int y) { return {1.0 / (1 + x), std::sqrt(2.0 + y), std::sin(x * 1000.0 + y)}; }

void paint(Tile tile, Colour* pixels, std::size_t stride, RayCounts& rays) {
    for (int y = tile.y0; y < tile.y1; ++y, pixels += stride)
        for (int x = tile.x0; x < tile.x1; ++x) pixels[x - tile.x0] = pixelAt(x, y);
    const auto count = static_cast<std::uint64_t>(tile.width()) * static_cast<std::uint64_t>(tile.height());
    rays.camera += count;
    rays.shadow += 2 * count;
}

bool isPainted(Framebuffer& framebuffer) {
    const Tile region = framebuffer.region();
    const ImageRows rows = framebuffer.rows();
    bool same = rows.width == region.width() && rows.height == region.height();
    for (int y = region.y1 - 1; y >= region.y0; --y) { // as some formats ask for them
        std::vector<Colour> expected;
        for (int x = region.x0; x < region.x1; ++x) expected.push_back(pixelAt(x, y));
        same &= std::memcmp(rows.row(y - region.y0), expected.data(), expected.size() * sizeof(Colour)) == 0;
    }
    return same;
}

bool hasNoChild() { return waitpid(-1, nullptr, WNOHANG) < 0 && errno == ECHILD; }

/// A number that all workers see.
class SharedCounter {
public:
    std::atomic<int>& operator*() const { return *value_; }

private:
    SharedMemory memory_ = mapSharedMemory(sizeof(std::atomic<int>));
    std::atomic<int>* value_ = new (memory_.get()) std::atomic<int>(0);
};

constexpr Tile image{0, 0, 100, 60};

TEST(Render, SamePixelsAndRaysInEveryModeForAnyTileSizeAndRegion) {
    struct Way {
        RenderMode mode;
        int workers;
    };
    const Way ways[] = {{RenderMode::serial, 1},    {RenderMode::processes, 1},  {RenderMode::processes, 2},
                        {RenderMode::processes, 7}, {RenderMode::processes, 64}, {RenderMode::threads, 1},
                        {RenderMode::threads, 2},   {RenderMode::threads, 3},    {RenderMode::threads, 4},
                        {RenderMode::threads, 5}};
    for (const Tile region : {image, Tile{13, 7, 14, 60}, Tile{99, 59, 100, 60}, Tile{3, 5, 80, 41}})
        for (const int side : {1, 7, 32, 1000})
            for (const Way way : ways) {
                SCOPED_TRACE(testing::Message()
                             << "mode " << static_cast<int>(way.mode) << ", workers " << way.workers
                             << ", tile " << side << ", region from " << region.x0);
                auto rendering = render({region, side, way.mode, way.workers}, paint, {});
                ASSERT_TRUE(rendering);
                ASSERT_TRUE(isPainted(rendering->framebuffer));
                const auto pixels = static_cast<std::uint64_t>(region.width() * region.height());
                EXPECT_EQ(rendering->rays, (RayCounts{pixels, 2 * pixels, 0, 0}));
            }
    EXPECT_TRUE(hasNoChild());
}

TEST(Render, StartsNoMoreWorkersThanThereAreTiles) {
    const auto workers = [](RenderMode mode, int wanted) {
        return render({{0, 0, 64, 32}, 32, mode, wanted}, paint, {})->workers;
    };
    EXPECT_EQ(workers(RenderMode::processes, 64), 2);
    EXPECT_EQ(workers(RenderMode::threads, 64), 2);
    EXPECT_EQ(workers(RenderMode::threads, 1), 1);
    EXPECT_EQ(workers(RenderMode::serial, 64), 0);
}

TEST(Render, ProcessesAndThreadsShareTheTiles) {
    for (const RenderMode mode : {RenderMode::processes, RenderMode::threads}) {
        // Each of the two tiles waits until the other was begun.
        const SharedCounter begun;
        const auto meet = [&](Tile tile, Colour* pixels, std::size_t stride, RayCounts& rays) {
            ++*begun;
            while (*begun < 2) std::this_thread::sleep_for(1ms);
            paint(tile, pixels, stride, rays);
        };
        EXPECT_TRUE(render({{0, 0, 64, 32}, 32, mode, 2}, meet, {}));
    }
}

TEST(Render, AWorkerThatIsKilledOnceOnEveryTileIsSurvived) {
    constexpr int tileCount = 12; // 4 x 3 tiles of 32
    const SharedMemory memory = mapSharedMemory(tileCount * sizeof(std::atomic<bool>));
    auto* const died = new (memory.get()) std::atomic<bool>[tileCount];
    const auto dieOnce = [&](Tile tile, Colour* pixels, std::size_t stride, RayCounts& rays) {
        paint(tile, pixels, stride, rays); // dies after its pixels and rays: they must not count twice
        if (!died[tile.y0 / 32 * 4 + tile.x0 / 32].exchange(true)) raise(SIGKILL);
    };
    for (const int workers : {1, 3}) {
        for (int i = 0; i < tileCount; ++i) died[i] = false;
        auto rendering = render({{0, 0, 100, 70}, 32, RenderMode::processes, workers}, dieOnce, {});
        ASSERT_TRUE(rendering);
        EXPECT_TRUE(isPainted(rendering->framebuffer));
        EXPECT_EQ(rendering->rays, (RayCounts{7000, 14000, 0, 0}));
    }
    EXPECT_TRUE(hasNoChild());
}

TEST(Render, ATileThatKillsTwiceEndsTheRenderByName) {
    const auto dieAt = [](int x, const std::function<void()>& die) -> TileFunction {
        return [=](Tile tile, Colour* pixels, std::size_t stride, RayCounts& rays) {
            if (tile.x0 == x && tile.y0 == 32) die();
            paint(tile, pixels, stride, rays);
        };
    };
    const auto messageOf = [](const TileFunction& tileFunction) -> std::string {
        try {
            render({image, 32, RenderMode::processes, 3}, tileFunction, {});
        } catch (const RenderError& error) {
            return error.what();
        }
        return "no error";
    };
    EXPECT_EQ(messageOf(dieAt(64, [] { raise(SIGKILL); })),
              "tile (64,32)-(96,60): its worker died twice (signal 9)");
    EXPECT_EQ(messageOf(dieAt(96, [] { throw std::bad_alloc(); })),
              "tile (96,32)-(100,60): its worker died twice (exit code 1)");
    EXPECT_TRUE(hasNoChild());
}

TEST(Render, WorkersKilledFromOutsideAtRandomMomentsChangeNothing) {
    const unsigned seed = std::random_device()();
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    // Workers leave their numbers; the progress function shoots at one of them now and then, at most once a
    // tile.
    const SharedMemory memory = mapSharedMemory(4 * sizeof(std::atomic<pid_t>));
    auto* const pids = new (memory.get()) std::atomic<pid_t>[4];
    const SharedCounter next;
    const auto slow = [&](Tile tile, Colour* pixels, std::size_t stride, RayCounts& rays) {
        pids[(*next)++ % 4] = getpid();
        std::this_thread::sleep_for(2ms);
        paint(tile, pixels, stride, rays);
    };
    int shots = 0;
    const auto shoot = [&](RenderProgress progress) {
        if (progress.done > progress.total / 2) return true;
        const pid_t victim = pids[random() % 4].exchange(0);
        if (victim != 0 && shots < 8 && kill(victim, SIGKILL) == 0) ++shots;
        return true;
    };
    auto rendering = render({image, 2, RenderMode::processes, 3}, slow, shoot);
    ASSERT_TRUE(rendering);
    EXPECT_TRUE(isPainted(rendering->framebuffer));
    EXPECT_EQ(rendering->rays, (RayCounts{6000, 12000, 0, 0}));
    EXPECT_GT(shots, 0);
}

TEST(Render, WhatATileThrowsComesOutOfThreadsAndOfTheReference) {
    const auto fail = [](Tile tile, Colour*, std::size_t, RayCounts&) {
        if (tile.x0 == 32) throw std::domain_error("tile 32");
    };
    EXPECT_THROW(render({image, 32, RenderMode::threads, 3}, fail, {}), std::domain_error);
    EXPECT_THROW(render({image, 32, RenderMode::serial, 1}, fail, {}), std::domain_error);
}

TEST(Render, StopsSoonWhenProgressSaysSo) {
    const auto slow = [](Tile, Colour*, std::size_t, RayCounts&) { std::this_thread::sleep_for(100ms); };
    const auto begin = std::chrono::steady_clock::now();
    for (const RenderMode mode : {RenderMode::serial, RenderMode::processes, RenderMode::threads})
        EXPECT_FALSE(render({image, 1, mode, 3}, slow, [](RenderProgress) { return false; }));
    // All 6000 tiles would take more than 200 s in each mode.
    EXPECT_LT(std::chrono::steady_clock::now() - begin, 20s);
    EXPECT_TRUE(hasNoChild());
}

TEST(Render, ProgressNeverFallsAndEndsWithAllTiles) {
    for (const RenderMode mode : {RenderMode::serial, RenderMode::processes, RenderMode::threads}) {
        std::vector<std::size_t> done;
        render({image, 10, mode, 2}, paint, [&](RenderProgress progress) {
            EXPECT_EQ(progress.total, 60u);
            done.push_back(progress.done);
            return true;
        });
        EXPECT_TRUE(std::is_sorted(done.begin(), done.end()));
        ASSERT_FALSE(done.empty());
        EXPECT_EQ(done.back(), 60u);
    }
}

} // namespace
} // namespace yarte
