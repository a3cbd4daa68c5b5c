#include "yarte/trace/tree.h"

#include "yarte/base/huge_pages.h"
#include "yarte/trace/tree_division.h"

#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <mutex>

namespace yarte::trace {
namespace {

constexpr int maxDepth = 56;
/// Subtrees of no more primitives are built by one thread.
constexpr std::size_t pieceSize = 1 << 14;

TreeNode nodeOf(const FloatBox& box, std::size_t first, std::size_t count) {
    return {{box.low[0], box.low[1], box.low[2]},
            static_cast<std::uint32_t>(first),
            {box.high[0], box.high[1], box.high[2]},
            static_cast<std::uint32_t>(count)};
}

/// Divides and divides again, large ranges by several threads.
class Builder {
public:
    /// `nodes` must have room for all that there can be, so that none moves; `order` gets the elements, leaf
    /// after leaf.
    Builder(std::vector<TreeNode>& nodes, std::vector<std::uint32_t>& order) : nodes_(nodes), order_(order) {}

    /// The subtree's root becomes nodes[at]; what is below it comes behind the nodes there are. Which of two
    /// threads is first there does not matter to those who search the tree.
    void build(std::size_t at, const BuildRange& range, int levels) {
        const auto parts = range.primitives.size() > pieceSize ? divide(range, levels) : std::nullopt;
        if (parts) {
            const std::size_t left = appendPair();
            nodes_[at] = nodeOf(range.box, left, 0);
            tbb::parallel_invoke([&] { build(left, parts->first, levels - 1); },
                                 [&] { build(left + 1, parts->second, levels - 1); });
            return;
        }
        std::vector<TreeNode> piece;
        piece.reserve(2 * range.primitives.size());
        piece.resize(1);
        buildPiece(0, range, levels, piece);
        const std::lock_guard lock(appending_);
        for (TreeNode& node : piece) // piece[1] is going to be the next
            if (node.count == 0) node.first += static_cast<std::uint32_t>(nodes_.size()) - 1;
        nodes_[at] = piece[0];
        nodes_.insert(nodes_.end(), piece.begin() + 1, piece.end());
    }

private:
    std::size_t appendPair() {
        const std::lock_guard lock(appending_);
        nodes_.resize(nodes_.size() + 2);
        return nodes_.size() - 2;
    }

    void buildPiece(std::size_t at, const BuildRange& range, int levels, std::vector<TreeNode>& piece) const {
        const auto parts = divide(range, levels);
        if (!parts) {
            piece[at] = nodeOf(range.box, range.firstEntry, range.entries);
            return list(range);
        }
        const std::size_t left = piece.size();
        piece[at] = nodeOf(range.box, left, 0);
        piece.resize(left + 2);
        if (parts->first.entries < parts->second.entries) {
            buildPiece(left, parts->second, levels - 1, piece);
            buildPiece(left + 1, parts->first, levels - 1, piece);
            return;
        }
        buildPiece(left, parts->first, levels - 1, piece);
        buildPiece(left + 1, parts->second, levels - 1, piece);
    }

    /// The elements of a leaf.
    void list(const BuildRange& range) const {
        const auto begin = order_.begin() + static_cast<std::ptrdiff_t>(range.firstEntry);
        auto end = begin;
        for (const BuildPrimitive& primitive : range.primitives)
            for (std::uint32_t i = 0; i < primitive.count; ++i) *end++ = primitive.element + i;
        std::sort(begin, end);
    }

    std::vector<TreeNode>& nodes_;
    std::vector<std::uint32_t>& order_;
    std::mutex appending_;
};

/// One step beyond the nearest float: outside whatever rounding happened on the way.
float roundDown(double v) { return std::nextafter(static_cast<float>(v), -FloatBox::infinity); }
float roundUp(double v) { return std::nextafter(static_cast<float>(v), FloatBox::infinity); }

} // namespace

Tree buildTree(const Bounds& all, std::size_t count, const std::function<Bounds(ElementId)>& boundsOf,
               double room) {
    Tree tree;
    if (all.isEmpty()) return tree;
    tree.centre = (all.low + all.high) / 2;
    tree.radius = length(all.high - all.low) / 2;
    tree.margin = boxMargin * tree.radius + room;
    const Vec3 widen{tree.margin, tree.margin, tree.margin};
    std::vector<BuildPrimitive> primitives;
    reserveWhole(primitives, count);
    for (std::uint32_t i = 0; i < count; ++i) {
        const Bounds bounds = boundsOf({i});
        if (bounds.isEmpty()) continue;
        const Vec3 low = bounds.low - tree.centre - widen, high = bounds.high - tree.centre + widen;
        const BuildPrimitive primitive{{{roundDown(low.x), roundDown(low.y), roundDown(low.z)},
                                        {roundUp(high.x), roundUp(high.y), roundUp(high.z)}},
                                       i};
        if (primitives.empty() || !unite(primitives.back(), primitive)) primitives.push_back(primitive);
    }
    const BuildRange range(primitives, 0);
    std::vector<std::uint32_t> order;
    reserveWhole(order, range.entries);
    order.resize(range.entries);
    reserveWhole(tree.nodes, 2 * primitives.size()); // at most; what is not needed is never touched
    tree.nodes.resize(1);
    Builder(tree.nodes, order).build(0, range, maxDepth);
    primitives = std::vector<BuildPrimitive>(); // a large tree is most of what memory must hold
    reserveWhole(tree.entries, order.size());
    for (const std::uint32_t element : order) tree.entries.push_back({{element}});
    return tree;
}

} // namespace yarte::trace
