#include "yarte/engine/tile_queue.h"

#include <gtest/gtest.h>

#include <set>
#include <thread>
#include <vector>

namespace yarte {
namespace {

TEST(TileQueue, DealsTilesInOrderUntilNoneWaits) {
    TileQueue queue(TileList({0, 0, 3, 1}, 1));
    EXPECT_EQ(queue.claim(0), 0u);
    EXPECT_EQ(queue.claim(5), 1u);
    EXPECT_EQ(queue.claim(0), 2u);
    EXPECT_EQ(queue.claim(0), std::nullopt);
    EXPECT_EQ(queue.finishedCount(), 0u);
}

TEST(TileQueue, WhatADeadWorkerHeldWaitsAgain) {
    TileQueue queue(TileList({0, 0, 4, 1}, 1));
    queue.claim(0);
    const auto lost = queue.claim(1);
    queue.claim(0);
    queue.claim(0);
    EXPECT_EQ(queue.putBack(2), std::nullopt);
    EXPECT_EQ(queue.putBack(1), lost);
    EXPECT_EQ(queue.putBack(1), std::nullopt);
    EXPECT_EQ(queue.claim(3), lost);
    EXPECT_EQ(queue.claim(3), std::nullopt);
}

TEST(TileQueue, FinishedTilesAreNotPutBackAndTheirCostsCountOnce) {
    TileQueue queue(TileList({0, 0, 2, 1}, 1));
    const TileCosts costs{{1, 20, 300, 4000}, {0.5, 60, 10, 20, 30}};
    const auto first = queue.claim(7);
    queue.finish(*first, costs);
    EXPECT_EQ(queue.putBack(7), std::nullopt);
    EXPECT_EQ(queue.finishedCount(), 1u);
    EXPECT_EQ(queue.costs(), costs);
    const auto second = queue.claim(7);
    EXPECT_EQ(queue.putBack(7), second);
    EXPECT_EQ(queue.costs(), costs);
    queue.finish(*queue.claim(8), costs);
    EXPECT_EQ(queue.costs(), (TileCosts{{2, 40, 600, 8000}, {1, 120, 20, 40, 60}}));
}

TEST(TileQueue, NoTileIsDealtTwiceToThreadsThatTakeAtTheSameTime) {
    constexpr std::size_t tileCount = 20000;
    TileQueue queue(TileList({0, 0, tileCount, 1}, 1));
    std::vector<std::vector<std::size_t>> taken(8);
    {
        std::vector<std::jthread> threads;
        for (std::size_t worker = 0; worker < taken.size(); ++worker)
            threads.emplace_back([&queue, &mine = taken[worker], worker] {
                while (const auto tile = queue.claim(static_cast<int>(worker))) mine.push_back(*tile);
            });
    }
    std::set<std::size_t> all;
    std::size_t count = 0;
    for (const auto& tiles : taken) {
        all.insert(tiles.begin(), tiles.end());
        count += tiles.size();
    }
    EXPECT_EQ(count, tileCount);
    EXPECT_EQ(all.size(), tileCount);
}

} // namespace
} // namespace yarte
