#include "yarte/trace/light_buffer.h"

#include "tests/support/scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace yarte;
using namespace yarte::trace;

namespace {

using Axes = double[3];

constexpr double farthest = 0x1p28; // as for doubles

struct Field {
    Tree tree;
    std::vector<Bounds> boxes; ///< of the tree's entries
};

Field boxField(int count, double spread, double size, unsigned seed, Vec3 centre = {}) {
    test::Random random(seed);
    std::vector<Bounds> elements;
    for (int i = 0; i < count; ++i) {
        const Vec3 low = centre + random.inCube(spread);
        elements.push_back(
            {low, low + Vec3{random.between(0, size), random.between(0, size), random.between(0, size)}});
    }
    Bounds all;
    for (const Bounds& box : elements) all.add(box);
    Field field{buildTree(all, elements.size(), [&](ElementId id) { return elements[id.index]; }), {}};
    for (const TreeEntry& entry : field.tree.entries) field.boxes.push_back(elements[entry.element.index]);
    return field;
}

bool contains(const LightBuffer& buffer, const LightBuffer::Cell& cell, double u, double v, double depth,
              std::uint32_t entry) {
    if (cell.blockCount == LightBuffer::Cell::crowded) return true; // the tree will find it
    for (std::uint32_t b = cell.firstBlock; b < cell.firstBlock + cell.blockCount; ++b) {
        const LightBuffer::Block& block = buffer.blocks[b];
        for (std::size_t i = 0; i < LightBuffer::Block::size; ++i)
            if (block.entry[i] == entry && block.uLow[i] <= u && u <= block.uHigh[i] && block.vLow[i] <= v &&
                v <= block.vHigh[i] && block.depth[i] <= cell.depthStep(static_cast<float>(depth)))
                return true;
    }
    return false;
}

/// Whether all faces that see `point` find `entry` there; at least one must see it.
bool isFound(const LightBuffer& buffer, Vec3 point, std::uint32_t entry) {
    const Vec3 way = point - buffer.light;
    const Axes along{way.x, way.y, way.z};
    bool isSeen = false;
    for (const LightBuffer::Face& face : buffer.faces) {
        const double depth = face.isDownwards ? -along[face.axis] : along[face.axis];
        const double a = along[(face.axis + 1) % 3], b = along[(face.axis + 2) % 3];
        if (depth <= 0 || std::abs(a) > depth || std::abs(b) > depth) continue;
        const double u = std::floor((a / depth - face.uLow) * face.uScale),
                     v = std::floor((b / depth - face.vLow) * face.vScale);
        const double column = std::floor(u / LightBuffer::stepsPerCell),
                     row = std::floor(v / LightBuffer::stepsPerCell);
        if (column < 0 || column >= face.columns || row < 0 || row >= face.rows) return false;
        const LightBuffer::Cell& cell =
            buffer.cells[face.firstCell + static_cast<std::size_t>(row * face.columns + column)];
        if (!contains(buffer, cell, u - column * LightBuffer::stepsPerCell,
                      v - row * LightBuffer::stepsPerCell, depth, entry))
            return false;
        isSeen = true;
    }
    return isSeen;
}

TEST(LightBuffer, EveryPointOfABoxIsSeenInACellThatListsIt) {
    for (const Vec3 light :
         {Vec3{0, 0, 0}, Vec3{30, 40, 20}, Vec3{0, 25, 0}, Vec3{1e6, -1e6, 3e5}, Vec3{10, 10, 10}}) {
        const Field field = boxField(2000, 10, 0.4, 5);
        const LightBuffer buffer = buildLightBuffer(field.tree, field.boxes, light, farthest);
        ASSERT_FALSE(buffer.empty());
        test::Random random(7);
        int missed = 0;
        for (std::uint32_t i = 0; i < field.boxes.size(); ++i)
            for (int k = 0; k < 20; ++k) {
                const Bounds& box = field.boxes[i];
                const auto pick = [&](double low, double high) { // corners, edges and sides, too
                    const int where = random.below(4);
                    return where == 0 ? low : where == 1 ? high : random.between(low, high);
                };
                missed += !isFound(
                    buffer,
                    {pick(box.low.x, box.high.x), pick(box.low.y, box.high.y), pick(box.low.z, box.high.z)},
                    i);
            }
        EXPECT_EQ(missed, 0) << "light at " << light.x << ' ' << light.y << ' ' << light.z;
    }
}

TEST(LightBuffer, ListsAreShort) {
    const Field field = boxField(2000, 10, 0.4, 5);
    const LightBuffer buffer = buildLightBuffer(field.tree, field.boxes, {30, 40, 20}, farthest);
    std::uint32_t longest = 0;
    for (const LightBuffer::Cell& cell : buffer.cells)
        if (cell.blockCount != LightBuffer::Cell::crowded) longest = std::max(longest, cell.blockCount);
    EXPECT_LE(longest, 8U);
    EXPECT_LT(buffer.blocks.size(), 4 * field.boxes.size());
}

TEST(LightBuffer, IsNotMadeWhereTheTreeIsBetter) {
    const Vec3 light{30, 40, 20};
    const Field crowded = boxField(2000, 1, 3, 1); // each over most others
    EXPECT_TRUE(buildLightBuffer(crowded.tree, crowded.boxes, light, farthest).empty());
    const Field field = boxField(2000, 10, 0.4, 1);
    EXPECT_FALSE(buildLightBuffer(field.tree, field.boxes, light, farthest).empty());
    EXPECT_TRUE(
        buildLightBuffer(field.tree, field.boxes, {1e12, 0, 0}, farthest).empty()); // slopes are rounded
    const Field far = boxField(2000, 10, 0.4, 1, {1e12, 0, 0});
    EXPECT_TRUE(buildLightBuffer(far.tree, far.boxes, {1e12, 30, 0}, farthest).empty());
}

} // namespace
