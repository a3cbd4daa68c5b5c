#include "yarte/trace/tree_division.h"

#include <array>

namespace yarte::trace {
namespace {

constexpr std::size_t maxLeafSize = 4;
constexpr int maxSlices = 32;
/// Of a node, in tests of elements. Measured: 1 makes trees of spheres and cones 1 to 5 % slower, 2 a seventh.
constexpr float traversalCost = 0.6f;

/// Equal slices of a range along each axis: in which of them does a primitive's centre lie?
class Slices {
public:
    /// Fewer for a small range: most of them would be empty.
    explicit Slices(const BuildRange& range)
        : count(static_cast<int>(std::min<std::size_t>(maxSlices, 4 + range.primitives.size() / 20))) {
        for (int axis = 0; axis < 3; ++axis) {
            from_[axis] = range.centres.low[axis];
            perUnit_[axis] = static_cast<float>(count) / (range.centres.high[axis] - from_[axis]);
        }
    }
    /// The last one, too, where there is no number: in a range that is as thin as a point, or too large.
    int of(const BuildPrimitive& primitive, int axis) const {
        const float place = (primitive.doubledCentre(axis) - from_[axis]) * perUnit_[axis];
        return place < static_cast<float>(count - 1) ? static_cast<int>(place) : count - 1;
    }

    const int count;

private:
    float from_[3], perUnit_[3];
};

/// Between which slices; the cost is in half areas times elements.
struct Division {
    float cost = FloatBox::infinity;
    int axis = 0, firstRight = 0;
};

Division cheapestDivision(const BuildRange& range, const Slices& slices) {
    struct Slice {
        FloatBox box;
        std::size_t size = 0;
        void add(const Slice& slice) { box.add(slice.box), size += slice.size; }
        /// No division leaves one side empty.
        float cost() const {
            return size > 0 ? static_cast<float>(size) * box.halfArea() : FloatBox::infinity;
        }
    };
    std::array<Slice, maxSlices> along[3];
    for (auto& axis : along) std::fill_n(axis.begin(), slices.count, Slice{});
    for (const BuildPrimitive& primitive : range.primitives)
        for (int axis = 0; axis < 3; ++axis)
            along[axis][static_cast<std::size_t>(slices.of(primitive, axis))].add(
                {primitive.box, primitive.count});
    Division best;
    for (int axis = 0; axis < 3; ++axis) {
        const std::span<const Slice> all(along[axis].data(), static_cast<std::size_t>(slices.count));
        std::array<float, maxSlices> rightCost;
        Slice right, left;
        for (std::size_t i = all.size(); i-- > 1;) {
            right.add(all[i]);
            rightCost[i] = right.cost();
        }
        for (std::size_t i = 1; i < all.size(); ++i) {
            left.add(all[i - 1]);
            const float cost = left.cost() + rightCost[i];
            if (cost < best.cost) best = {cost, axis, static_cast<int>(i)};
        }
    }
    return best;
}

std::pair<BuildRange, BuildRange> part(const BuildRange& range, const Slices& slices,
                                       const Division& division) {
    BuildRange left, right;
    auto begin = range.primitives.begin(), end = range.primitives.end();
    while (begin != end) {
        if (slices.of(*begin, division.axis) < division.firstRight)
            left.count(*begin++);
        else
            right.count(*begin), std::swap(*begin, *--end);
    }
    left.primitives = {range.primitives.begin(), begin}, right.primitives = {begin, range.primitives.end()};
    left.firstEntry = range.firstEntry, right.firstEntry = range.firstEntry + left.entries;
    return {left, right};
}

std::pair<BuildRange, BuildRange> halve(const BuildRange& range) {
    const std::size_t half = range.primitives.size() / 2;
    const BuildRange left(range.primitives.first(half), range.firstEntry);
    return {left, BuildRange(range.primitives.subspan(half), range.firstEntry + left.entries)};
}

} // namespace

bool unite(BuildPrimitive& a, const BuildPrimitive& b) {
    if (a.count > 1 || b.element != a.element + 1) return false;
    FloatBox both = a.box;
    both.add(b.box);
    const float asLeaf = 2 * both.halfArea(),
                asNode = traversalCost * both.halfArea() + a.box.halfArea() + b.box.halfArea();
    if (!(asLeaf <= asNode)) return false;
    a.box = both, a.count = 2;
    return true;
}

BuildRange::BuildRange(std::span<BuildPrimitive> all, std::size_t first)
    : primitives(all), firstEntry(first) {
    for (const BuildPrimitive& primitive : all) count(primitive);
}

void BuildRange::count(const BuildPrimitive& primitive) {
    entries += primitive.count;
    box.add(primitive.box);
    for (int axis = 0; axis < 3; ++axis) {
        const float centre = primitive.doubledCentre(axis);
        centres.low[axis] = std::min(centres.low[axis], centre);
        centres.high[axis] = std::max(centres.high[axis], centre);
    }
}

std::optional<std::pair<BuildRange, BuildRange>> divide(const BuildRange& range, int levels) {
    const std::size_t size = range.primitives.size();
    if (size == 1) return std::nullopt;
    // A division may leave all but one on one side: only where there are levels enough for that.
    const bool mustHalve = size > std::size_t{1} << (levels - 1);
    const Slices slices(range);
    const Division division = mustHalve ? Division{} : cheapestDivision(range, slices);
    const float area = range.box.halfArea();
    const float asLeaf = static_cast<float>(range.entries) * area,
                asNode = traversalCost * area + division.cost;
    if (range.entries <= maxLeafSize && !(asLeaf > asNode)) return std::nullopt;
    return division.cost < FloatBox::infinity ? part(range, slices, division) : halve(range);
}

} // namespace yarte::trace
