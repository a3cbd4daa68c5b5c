// Where a tree's builder divides the elements of a node.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <utility>

namespace yarte::trace {

/// In float; empty until something is added.
struct FloatBox {
    static constexpr float infinity = std::numeric_limits<float>::infinity();
    float low[3] = {infinity, infinity, infinity}, high[3] = {-infinity, -infinity, -infinity};

    void add(const FloatBox& b) {
        for (int i = 0; i < 3; ++i)
            low[i] = std::min(low[i], b.low[i]), high[i] = std::max(high[i], b.high[i]);
    }
    float halfArea() const {
        const float x = high[0] - low[0], y = high[1] - low[1], z = high[2] - low[2];
        return x * y + y * z + z * x;
    }
};

/// What the builder does not part: an element, or two that follow each other.
struct BuildPrimitive {
    FloatBox box;
    std::uint32_t element, count = 1;

    float doubledCentre(int axis) const { return box.low[axis] + box.high[axis]; }
};

/// True, and both are in `a`, if a leaf of the two costs no more than a node with a leaf for each. So it is
/// with the halves of a square, of which many large meshes consist: then there is half as much to build.
bool unite(BuildPrimitive& a, const BuildPrimitive& b);

/// Primitives that become one subtree.
struct BuildRange {
    std::span<BuildPrimitive> primitives;
    std::size_t firstEntry = 0, entries = 0; ///< where the elements go in Tree::entries
    FloatBox box, centres;                   ///< centres: of the doubled centres

    BuildRange() = default;
    BuildRange(std::span<BuildPrimitive> all, std::size_t first);
    /// As one of `primitives`.
    void count(const BuildPrimitive&);
};

/// The parts of a range by the surface area heuristic [MacDonald, Booth, "Heuristics for ray tracing using
/// space subdivision", 1990], looked for between slices of the range [Wald, "On fast Construction of
/// SAH-based Bounding Volume Hierarchies", RT 2007]; or nothing if it should be a leaf. Reorders the
/// primitives. `levels` is what the tree may still grow: the range must not have more than 2^levels
/// primitives, and then its parts have no more than half of that.
std::optional<std::pair<BuildRange, BuildRange>> divide(const BuildRange& range, int levels);

} // namespace yarte::trace
