// A packet's way through the tree: all lanes together, boxes in float. Culling only: it never changes which
// element is hit.
#if defined(YARTE_TRACE_LANES_TREE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef YARTE_TRACE_LANES_TREE_INL_H
#undef YARTE_TRACE_LANES_TREE_INL_H
#else
#define YARTE_TRACE_LANES_TREE_INL_H
#endif

#include "yarte/trace/lanes/packet-inl.h"
#include "yarte/trace/tree.h"

#include <limits>
#include <type_traits>

HWY_BEFORE_NAMESPACE();
namespace yarte::trace::HWY_NAMESPACE::YARTE_PRECISION {

/// A packet's rays relative to the tree's centre, in float. A ray that starts far outside the tree is moved
/// up to it first (before it is rounded to float), so that float always has the tree's own scale to work on.
struct alignas(64) SlabPacket {
    float ix[lanes], iy[lanes], iz[lanes]; ///< inverse direction
    float ox[lanes], oy[lanes], oz[lanes]; ///< origin times inverse direction
    float tMax[lanes];                     ///< from the moved origin, rounded up
    Scalar moved[lanes];                   ///< how far

    HWY_INLINE SlabPacket(const Tree& tree, const RayPacket& rays, const Scalar* distance) {
        for (std::size_t at = 0; at < lanes; at += half) {
            const V3 o = rays.origin(at) - spread(tree.centre), d = rays.direction(at);
            const V ahead = greatest(set(0), hn::Neg(dot(o, d)) - set(tree.radius));
            const V3 start = o + d * ahead;
            store(ahead, moved + at);
            demote(start.x, ox + at), demote(start.y, oy + at), demote(start.z, oz + at);
            demote(d.x, ix + at), demote(d.y, iy + at), demote(d.z, iz + at);
        }
        invert(ix, ox), invert(iy, oy), invert(iz, oz);
        setMax(distance);
    }
    HWY_INLINE void setMax(const Scalar* t) {
        for (std::size_t at = 0; at < lanes; at += half)
            demote(least((load(t + at) - load(moved + at)) * set(1 + 0x1p-22), set(largest)), tMax + at);
    }

private:
    static constexpr Scalar largest = std::numeric_limits<float>::max(); // nearer than what is missed

    template <class Vector> // V, of whichever scalars
    HWY_INLINE static void demote(Vector v, float* to) {
        const hn::Rebind<float, D> f;
        if constexpr (std::is_same_v<Vector, hn::Vec<decltype(f)>>)
            hn::Store(v, f, to);
        else
            hn::Store(hn::DemoteTo(f, v), f, to);
    }
    /// Along an axis where the direction's component is so small that its inverse would overflow, the line
    /// stands still.
    HWY_INLINE static void invert(float* direction, float* origin) {
        const F f;
        const VF d = hn::Load(f, direction);
        const VF inverse = hn::Set(f, 1) / hn::CopySign(hn::Max(hn::Abs(d), hn::Set(f, 1e-18f)), d);
        hn::Store(inverse, f, direction);
        hn::Store(hn::Load(f, origin) * inverse, f, origin);
    }
};

/// Where the lanes enter the box, or infinity in those that miss it; `hits` tells which do not. Products may
/// be fused here: the boxes' margin (boxMargin) covers every rounding.
HWY_INLINE VF enterBox(const TreeNode& node, const SlabPacket& rays, MF& hits) {
    const F f;
    const auto slab = [&](float low, float high, const float* o, const float* i, VF& from, VF& to) HWY_ATTR {
        const VF origin = hn::Load(f, o), inverse = hn::Load(f, i);
        const VF a = hn::MulSub(hn::Set(f, low), inverse, origin),
                 b = hn::MulSub(hn::Set(f, high), inverse, origin);
        from = hn::Max(from, hn::Min(a, b)), to = hn::Min(to, hn::Max(a, b));
    };
    VF from = hn::Zero(f), to = hn::Load(f, rays.tMax);
    slab(node.low[0], node.high[0], rays.ox, rays.ix, from, to);
    slab(node.low[1], node.high[1], rays.oy, rays.iy, from, to);
    slab(node.low[2], node.high[2], rays.oz, rays.iz, from, to);
    hits = from <= to;
    return hn::IfThenElse(hits, from, hn::Set(f, Bounds::infinity));
}

/// Calls `leaf(node, mask)` for the leaves that some lane may meet, near ones first; `mask` has a bit for
/// each such lane. `leaf` may lower rays.tMax, and ends the search by returning true.
///
/// Whether a farther child waits is as good as random, so nothing branches on it: it is put on the stack's
/// top in any case, to stay there or be overwritten. Which child is nearer is guessed well enough for a
/// branch to be faster than to wait for the answer.
template <class Leaf>
HWY_INLINE void traverse(const Tree& tree, SlabPacket& rays, Leaf&& leaf) {
    const F f;
    struct alignas(64) Pending {
        float enter[lanes];
        std::uint32_t node;
    };
    Pending stack[66]; // the builder's depth, and one above the top
    int size = 0;
    MF hits;
    hn::Store(enterBox(tree.nodes[0], rays, hits), f, stack[0].enter);
    stack[0].node = 0;
    if (!hn::AllFalse(f, hits)) size = 1;
    while (size > 0) {
        const float* enter = stack[--size].enter; // of `node`
        const TreeNode* node = &tree.nodes[stack[size].node];
        // Not <: of two at equal distance the first in the file must be found.
        if (hn::AllFalse(f, hn::Load(f, enter) <= hn::Load(f, rays.tMax))) continue;
        while (node->count == 0) {
            MF leftHits, rightHits;
            const TreeNode* const children = &tree.nodes[node->first];
            const VF leftEnter = enterBox(children[0], rays, leftHits),
                     rightEnter = enterBox(children[1], rays, rightHits);
            const bool missesLeft = hn::AllFalse(f, leftHits), missesRight = hn::AllFalse(f, rightHits);
            if (missesLeft && missesRight) {
                node = nullptr;
                break;
            }
            // A child that all lanes miss is infinitely far away.
            const bool rightFirst =
                hn::CountTrue(f, leftEnter < rightEnter) < hn::CountTrue(f, rightEnter < leftEnter);
            hn::Store(leftEnter, f, stack[size + (rightFirst ? 0 : 1)].enter);
            hn::Store(rightEnter, f, stack[size + (rightFirst ? 1 : 0)].enter);
            stack[size].node = node->first + (rightFirst ? 0 : 1);
            enter = stack[size + 1].enter;
            node = &children[rightFirst ? 1 : 0];
            size += missesLeft || missesRight ? 0 : 1;
        }
        if (node && leaf(*node, bitsOf(f, hn::Load(f, enter) <= hn::Load(f, rays.tMax)))) return;
    }
}

} // namespace yarte::trace::HWY_NAMESPACE::YARTE_PRECISION
HWY_AFTER_NAMESPACE();

#endif
