// Tree: a binary hierarchy of bounding boxes over elements. Culling is conservative: it never changes which
// element is hit.
#pragma once

#include "yarte/trace/bounds.h"
#include "yarte/trace/ray.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace yarte::trace {

/// Boxes in float, relative to Tree::centre and rounded outwards; two nodes fill a cache line.
struct TreeNode {
    float low[3];
    std::uint32_t first; ///< leaf: first of Tree::entries; else the left child, the right one following it
    float high[3];
    std::uint32_t count; ///< leaf: number of entries; else 0
};

/// An element in a leaf. The corners of a triangle are copied here: the way to them over the world's tables
/// costs a cache miss at every step, and large meshes are searched for little else.
struct TreeEntry {
    static constexpr std::uint32_t noTriangle = 0xffffffff;
    ElementId element;
    std::uint32_t corners[3] = {noTriangle, 0, 0}; ///< into FaceTable::vertices
};

struct Tree {
    Vec3 centre;                    ///< of all elements
    double radius = 0;              ///< of a sphere about the centre that holds all elements
    double margin = 0;              ///< what the elements' boxes are widened by
    std::vector<TreeNode> nodes;    ///< nodes[0] is the root
    std::vector<TreeEntry> entries; ///< leaf after leaf
    bool empty() const { return nodes.empty(); }
};

/// Below this many elements testing all of them is faster than a tree.
inline constexpr std::size_t minElementsForTree = 12;

/// Every box is widened by this fraction of the tree's radius: room for tracing through it in float, whose
/// rounding moves a line by less than 10 * 2^-24 radii, and for the rounding of the shapes' own arithmetic.
inline constexpr double boxMargin = 2e-6;

/// Over the elements of numbers below `count`, but for those whose bounds are empty; `all` holds all of them.
/// By surface area; see tree_division.h. The boxes are widened by `room`, too.
Tree buildTree(const Bounds& all, std::size_t count, const std::function<Bounds(ElementId)>& boundsOf,
               double room = 0);

/// The slab test's constants for one ray. A direction component of 0 becomes a slope so steep that the line
/// stays where it is, but products with 0 remain numbers.
struct SlabRay {
    Vec3 origin, inverse;

    SlabRay(const Tree& tree, const Ray& ray) : origin(ray.origin - tree.centre) {
        const auto invert = [](double d) { return std::copysign(std::min(1 / std::abs(d), 1e200), d); };
        inverse = {invert(ray.direction.x), invert(ray.direction.y), invert(ray.direction.z)};
    }

    /// The smallest t >= 0 at which the line may be in the box, or infinity if that is beyond tMax. Rounding
    /// is covered by widening the far end [Ize, "Robust BVH Ray Traversal", JCGT 2013].
    double enter(const TreeNode& node, double tMax) const {
        constexpr double widen = 1 + 8 * 0x1p-53;
        const auto axis = [](double low, double high, double o, double i, double& from, double& to) {
            const double a = (low - o) * i, b = (high - o) * i;
            from = std::max(from, std::min(a, b)), to = std::min(to, std::max(a, b) * widen);
        };
        double from = 0, to = tMax;
        axis(node.low[0], node.high[0], origin.x, inverse.x, from, to);
        axis(node.low[1], node.high[1], origin.y, inverse.y, from, to);
        axis(node.low[2], node.high[2], origin.z, inverse.z, from, to);
        return from <= to ? from : Bounds::infinity;
    }
};

/// Calls `visit(ElementId)` for every element whose box the ray may meet at t in [0, tMax], near boxes first;
/// `visit` may lower tMax, and ends the search by returning true.
template <class Visit>
void traverse(const Tree& tree, const Ray& ray, double& tMax, Visit&& visit) {
    struct Pending {
        std::uint32_t node;
        double enter;
    };
    // Deeper than any tree that the builder makes (Tree's builder limits the depth).
    Pending stack[64];
    int size = 0;
    const SlabRay slab(tree, ray);
    const double rootEnter = slab.enter(tree.nodes[0], tMax);
    if (rootEnter != Bounds::infinity) stack[size++] = {0, rootEnter};
    while (size > 0) {
        const auto [index, enter] = stack[--size];
        if (enter > tMax) continue; // not >=: of two at equal distance the first in the file must be found
        const TreeNode& node = tree.nodes[index];
        if (node.count > 0) {
            for (std::uint32_t i = 0; i < node.count; ++i)
                if (visit(tree.entries[node.first + i].element)) return;
            continue;
        }
        Pending near{node.first, slab.enter(tree.nodes[node.first], tMax)};
        Pending far{node.first + 1, slab.enter(tree.nodes[node.first + 1], tMax)};
        if (far.enter < near.enter) std::swap(near, far);
        if (far.enter != Bounds::infinity) stack[size++] = far;
        if (near.enter != Bounds::infinity) stack[size++] = near;
    }
}

} // namespace yarte::trace
