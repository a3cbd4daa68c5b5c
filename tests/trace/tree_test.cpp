#include "yarte/trace/tree.h"

#include "tests/support/scenes.h"
#include "yarte/trace/tree_division.h"

#include <gtest/gtest.h>

using namespace yarte;
using namespace yarte::trace;

namespace {

Tree treeOver(const std::vector<Bounds>& boxes) {
    Bounds all;
    for (const Bounds& box : boxes) all.add(box);
    return buildTree(all, boxes.size(), [&](ElementId element) { return boxes[element.index]; });
}

/// Visits the whole tree: every box holds what is below it, every element is in one leaf, and no way is
/// longer than a search's stack.
class Inspection {
public:
    Inspection(const Tree& tree, const std::vector<Bounds>& boxes)
        : tree_(tree), boxes_(boxes), seen_(boxes.size()) {
        visit(tree.nodes[0], 0);
        for (std::size_t i = 0; i < boxes.size(); ++i)
            EXPECT_EQ(seen_[i], boxes[i].isEmpty() ? 0 : 1) << "element " << i;
        EXPECT_LE(depth_, 56);
    }
    int depth() const { return depth_; }
    std::size_t leaves() const { return leaves_; }

private:
    Bounds visit(const TreeNode& node, int depth) {
        depth_ = std::max(depth_, depth);
        Bounds inside;
        if (node.count > 0) {
            ++leaves_;
            for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
                const std::uint32_t element = tree_.entries[i].element.index;
                ++seen_[element];
                inside.add({boxes_[element].low - tree_.centre, boxes_[element].high - tree_.centre});
                EXPECT_TRUE(i == node.first || tree_.entries[i - 1].element.index < element);
            }
        } else {
            inside.add(visit(tree_.nodes[node.first], depth + 1));
            inside.add(visit(tree_.nodes[node.first + 1], depth + 1));
        }
        EXPECT_TRUE(node.low[0] <= inside.low.x && node.low[1] <= inside.low.y &&
                    node.low[2] <= inside.low.z);
        EXPECT_TRUE(node.high[0] >= inside.high.x && node.high[1] >= inside.high.y &&
                    node.high[2] >= inside.high.z);
        return inside;
    }

    const Tree& tree_;
    const std::vector<Bounds>& boxes_;
    std::vector<int> seen_;
    int depth_ = 0;
    std::size_t leaves_ = 0;
};

std::vector<Bounds> scattered(int count) {
    test::Random random(static_cast<unsigned>(count));
    std::vector<Bounds> boxes;
    for (int i = 0; i < count; ++i) {
        const Vec3 centre = random.inCube(10), half = random.inCube(0.2);
        Bounds box;
        box.add(centre - half), box.add(centre + half);
        boxes.push_back(box);
    }
    return boxes;
}

TEST(Tree, HoldsEveryElementOnce) {
    for (const int count : {1, 2, 3, 5, 100, 5000, 100000}) { // the last by several threads
        const std::vector<Bounds> boxes = scattered(count);
        const Tree tree = treeOver(boxes);
        EXPECT_LE(Inspection(tree, boxes).depth(), 4 * std::log2(count) + 1) << count;
    }
}

TEST(Tree, LeavesOutWhatIsEmpty) {
    std::vector<Bounds> boxes = scattered(50);
    for (std::size_t i = 0; i < boxes.size(); i += 3) boxes[i] = {};
    const Tree tree = treeOver(boxes);
    EXPECT_EQ(tree.entries.size(), 33U);
    Inspection(tree, boxes);
}

TEST(Tree, OfElementsInOnePlaceIsBalanced) {
    const std::vector<Bounds> boxes(1000, Bounds{{1, 2, 3}, {4, 5, 6}});
    const Tree tree = treeOver(boxes);
    EXPECT_LE(Inspection(tree, boxes).depth(), 10);
}

int depthBelow(const BuildRange& range, int levels) {
    const auto parts = divide(range, levels);
    if (!parts) return 0;
    return 1 + std::max(depthBelow(parts->first, levels - 1), depthBelow(parts->second, levels - 1));
}

/// Of elements that are each larger than all before, the heuristic takes off one at a time.
TEST(Tree, GrowsNoMoreThanItsLevels) {
    for (const int levels : {56, 9, 8}) {
        std::vector<BuildPrimitive> primitives;
        float x = 1e-15f;
        for (std::uint32_t i = 0; i < 256; ++i, x *= 1.3f)
            primitives.push_back({{{x, 0, 0}, {1.2f * x, x, x}}, 2 * i});
        const int depth = depthBelow(BuildRange(primitives, 0), levels);
        EXPECT_LE(depth, levels);
        EXPECT_GT(depth, levels == 56 ? 20 : 4);
    }
}

/// Beyond what floats hold nothing can be told apart, but no element is lost.
TEST(Tree, OfHugeElements) {
    std::vector<Bounds> boxes = scattered(300);
    for (Bounds& box : boxes) box = {box.low * 1e200, box.high * 1e200};
    const Tree tree = treeOver(boxes);
    Inspection(tree, boxes);
}

TEST(Tree, HalvesOfSquaresShareALeaf) {
    std::vector<Bounds> boxes;
    for (int i = 0; i < 100; ++i)
        for (int j = 0; j < 100; ++j)
            for (int half = 0; half < 2; ++half)
                boxes.push_back({{double(i), double(j), 0}, {double(i + 1), double(j + 1), 0.1}});
    const Tree tree = treeOver(boxes);
    EXPECT_LE(Inspection(tree, boxes).leaves(), 10000U);
    for (const TreeNode& node : tree.nodes) EXPECT_EQ(node.count % 2, 0U);
}

} // namespace
