#include "yarte/engine/tile_list.h"

#include <gtest/gtest.h>

#include <climits>
#include <random>
#include <vector>

namespace yarte {
namespace {

TEST(TileList, GoesRowByRowWithSmallerTilesAtTheEdges) {
    const TileList tiles({10, 20, 17, 25}, 4);
    ASSERT_EQ(tiles.size(), 4u);
    EXPECT_EQ(tiles[0], (Tile{10, 20, 14, 24}));
    EXPECT_EQ(tiles[1], (Tile{14, 20, 17, 24}));
    EXPECT_EQ(tiles[2], (Tile{10, 24, 14, 25}));
    EXPECT_EQ(tiles[3], (Tile{14, 24, 17, 25}));
}

TEST(TileList, CoversEveryPixelOfTheRegionOnce) {
    const unsigned seed = std::random_device()();
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    const auto number = [&](int from, int to) { return std::uniform_int_distribution(from, to)(random); };
    for (int round = 0; round < 200; ++round) {
        const int x0 = number(0, 20), y0 = number(0, 20);
        const Tile region{x0, y0, x0 + number(1, 40), y0 + number(1, 40)};
        const int side = number(1, 50);
        const TileList tiles(region, side);
        std::vector<int> covered(60 * 60);
        for (std::size_t i = 0; i < tiles.size(); ++i) {
            const Tile tile = tiles[i];
            ASSERT_LE(tile.width(), side);
            ASSERT_LE(tile.height(), side);
            for (int y = tile.y0; y < tile.y1; ++y)
                for (int x = tile.x0; x < tile.x1; ++x) ++covered[static_cast<std::size_t>(y * 60 + x)];
        }
        for (int y = 0; y < 60; ++y)
            for (int x = 0; x < 60; ++x) {
                const bool inside = x >= region.x0 && x < region.x1 && y >= region.y0 && y < region.y1;
                ASSERT_EQ(covered[static_cast<std::size_t>(y * 60 + x)], inside ? 1 : 0) << x << ' ' << y;
            }
    }
}

TEST(TileList, LargestRegionAndLargestSideDoNotOverflow) {
    const TileList one({0, 0, INT_MAX, INT_MAX}, INT_MAX);
    ASSERT_EQ(one.size(), 1u);
    EXPECT_EQ(one[0], (Tile{0, 0, INT_MAX, INT_MAX}));
    const TileList many({0, 0, INT_MAX, INT_MAX}, 1 << 20);
    ASSERT_EQ(many.size(), 2048u * 2048u);
    EXPECT_EQ(many[many.size() - 1], (Tile{2047 << 20, 2047 << 20, INT_MAX, INT_MAX}));
}

TEST(TileList, TilesAreSmallWhereManyWorkersWouldGetFewLargeOnes) {
    const Tile image{0, 0, 1024, 1024}; // 1024 tiles of 32
    for (const int workers : {0, 1, 2, 64}) EXPECT_EQ(suitableTileSide(image, workers), 32) << workers;
    for (const int workers : {65, 256, 100000}) EXPECT_EQ(suitableTileSide(image, workers), 16) << workers;
    EXPECT_EQ(suitableTileSide({7, 7, 8, 8}, 1), 32) << "nobody waits for another";
    EXPECT_EQ(suitableTileSide({7, 7, 8, 8}, 2), 16);
}

} // namespace
} // namespace yarte
