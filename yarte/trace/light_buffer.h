// LightBuffer: for each direction from a light, what may stand in its way [Haines, Greenberg, "The Light
// Buffer: A Shadow-Testing Accelerator", IEEE Computer Graphics and Applications, 1986]. Culling is
// conservative: it never changes what is in shadow.
#pragma once

#include "yarte/trace/bounds.h"
#include "yarte/trace/tree.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace yarte::trace {

/// A cube around the light. Each of its faces has a grid over the part on which elements are seen.
struct LightBuffer {
    /// Faces are seen along an axis, 0, 1 or 2, upwards or downwards. Slopes u and v of a direction are its
    /// components along the two axes that follow (cyclically), divided by its depth along this one. Cells lie
    /// row by row.
    struct Face {
        int axis = 0;
        bool isDownwards = false;
        double uLow = 0, vLow = 0, uScale = 0, vScale = 0; ///< slopes to steps: (u - uLow) * uScale
        std::uint32_t columns = 0, rows = 0, firstCell = 0;
    };
    static constexpr int stepsPerCell = 256; ///< in both directions, and of depth

    struct Cell {
        static constexpr std::uint32_t crowded = 0xffffffff; ///< as blockCount: the tree is faster
        std::uint32_t firstBlock = 0, blockCount = 0;
        float depthLow = 0, depthScale = 0; ///< for Block::depth

        /// Never falls as `depth` grows.
        std::uint8_t depthStep(float depth) const {
            return static_cast<std::uint8_t>(std::clamp((depth - depthLow) * depthScale, 0.0f, 255.0f));
        }
    };
    /// Elements seen in a cell: the steps that they cover, and the one in which their depth begins. Unused
    /// places cover none.
    struct Block {
        static constexpr std::size_t size = 8;
        alignas(8) std::uint8_t uLow[size], uHigh[size], vLow[size], vHigh[size], depth[size];
        std::uint32_t entry[size]; ///< of Tree::entries
    };

    Vec3 light;
    std::vector<Face> faces; ///< those that see anything
    std::vector<Cell> cells;
    std::vector<Block> blocks;

    bool empty() const { return faces.empty(); }
};

/// `boxes` are those of `tree.entries`, in their order. Empty where many elements crowd together, which the
/// tree is better at, and where the light or the tree is farther away than `farthest` radii of the tree:
/// slopes and coordinates as they are rounded there must be exact to well within the tree's margin.
LightBuffer buildLightBuffer(const Tree& tree, std::span<const Bounds> boxes, Vec3 light, double farthest);

} // namespace yarte::trace
