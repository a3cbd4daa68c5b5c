#include "yarte/trace/tree.h"

#include "yarte/base/huge_pages.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <memory>
#include <new>
#include <stdexcept>

namespace yarte::trace {
namespace {

constexpr unsigned maxDepth = 56;
constexpr unsigned maxLeafSize = 4;

/// The tree as Embree's callbacks make it, in Embree's arena; flattened afterwards. A child is a node or a
/// leaf; to the builder both are pointers.
struct BuiltBox {
    float low[3], high[3];
};
struct alignas(64) BuiltNode {
    BuiltBox boxes[2];
    void* children[2];
};

/// A leaf is no pointer to anything, but two numbers in one: nothing needs to be allocated for it.
struct BuiltLeaf {
    std::uint32_t first, count; ///< of Building::order

    void* asChild() const {
        return reinterpret_cast<void*>(std::uintptr_t{first} << 8 | std::uintptr_t{count} << 1 | 1);
    }
    static bool is(const void* child) { return (reinterpret_cast<std::uintptr_t>(child) & 1) != 0; }
    static BuiltLeaf of(const void* child) {
        const auto bits = reinterpret_cast<std::uintptr_t>(child);
        return {static_cast<std::uint32_t>(bits >> 8), static_cast<std::uint32_t>(bits >> 1 & 0x7f)};
    }
};
static_assert(sizeof(void*) == 8 && maxLeafSize < 128);

/// What the builder's callbacks know. It sorts the primitives where they are, so that leaves are ranges.
struct Building {
    const RTCBuildPrimitive* primitives;
    std::uint32_t* order; ///< the primitives' numbers, leaf after leaf
};

void* createNode(RTCThreadLocalAllocator allocator, unsigned, void*) {
    return new (rtcThreadLocalAlloc(allocator, sizeof(BuiltNode), alignof(BuiltNode))) BuiltNode;
}

void setChildren(void* node, void** children, unsigned count, void*) {
    std::copy_n(children, count, static_cast<BuiltNode*>(node)->children);
}

void setBounds(void* node, const RTCBounds** bounds, unsigned count, void*) {
    for (unsigned i = 0; i < count; ++i) {
        const RTCBounds& b = *bounds[i];
        static_cast<BuiltNode*>(node)->boxes[i] = {{b.lower_x, b.lower_y, b.lower_z},
                                                   {b.upper_x, b.upper_y, b.upper_z}};
    }
}

void* createLeaf(RTCThreadLocalAllocator, const RTCBuildPrimitive* primitives, std::size_t count,
                 void* user) {
    const Building& building = *static_cast<const Building*>(user);
    const std::ptrdiff_t first = primitives - building.primitives;
    std::uint32_t* const order = building.order + first;
    for (std::size_t i = 0; i < count; ++i) order[i] = primitives[i].primID;
    std::sort(order, order + count);
    return BuiltLeaf{static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(count)}.asChild();
}

std::size_t countNodes(const void* built) {
    if (BuiltLeaf::is(built)) return 1;
    const auto& node = *static_cast<const BuiltNode*>(built);
    return 1 + countNodes(node.children[0]) + countNodes(node.children[1]);
}

/// One step beyond the nearest float: outside whatever rounding happened on the way.
float roundDown(double v) {
    return std::nextafter(static_cast<float>(v), -std::numeric_limits<float>::infinity());
}
float roundUp(double v) {
    return std::nextafter(static_cast<float>(v), std::numeric_limits<float>::infinity());
}

/// Writes `built`, with the given box, to nodes[at], and what is below it behind the nodes there are.
void flatten(const void* built, const BuiltBox& box, std::size_t at, std::vector<TreeNode>& nodes) {
    TreeNode node{{box.low[0], box.low[1], box.low[2]}, 0, {box.high[0], box.high[1], box.high[2]}, 0};
    if (BuiltLeaf::is(built)) {
        const BuiltLeaf leaf = BuiltLeaf::of(built);
        node.first = leaf.first, node.count = leaf.count;
        nodes[at] = node;
        return;
    }
    const std::size_t left = nodes.size();
    node.first = static_cast<std::uint32_t>(left);
    nodes[at] = node;
    nodes.resize(left + 2);
    const auto& children = *static_cast<const BuiltNode*>(built);
    for (std::size_t i = 0; i < 2; ++i) flatten(children.children[i], children.boxes[i], left + i, nodes);
}

} // namespace

Tree buildTree(const Bounds& all, std::size_t count, const std::function<Bounds(ElementId)>& boundsOf,
               double room) {
    Tree tree;
    if (all.isEmpty()) return tree;
    tree.centre = (all.low + all.high) / 2;
    tree.radius = length(all.high - all.low) / 2;
    tree.margin = boxMargin * tree.radius + room;
    const Vec3 widen{tree.margin, tree.margin, tree.margin};
    const auto boxOf = [&](const Bounds& b, std::uint32_t id) -> RTCBuildPrimitive {
        const Vec3 low = b.low - tree.centre - widen, high = b.high - tree.centre + widen;
        return {roundDown(low.x), roundDown(low.y), roundDown(low.z), 0,
                roundUp(high.x),  roundUp(high.y),  roundUp(high.z),  id};
    };
    std::vector<RTCBuildPrimitive> primitives;
    reserveWhole(primitives, count);
    for (std::uint32_t i = 0; i < count; ++i)
        if (const Bounds b = boundsOf({i}); !b.isEmpty()) primitives.push_back(boxOf(b, i));
    const RTCBuildPrimitive root = boxOf(all, 0);
    const BuiltBox whole{{root.lower_x, root.lower_y, root.lower_z},
                         {root.upper_x, root.upper_y, root.upper_z}};
    std::vector<std::uint32_t> order;
    reserveWhole(order, primitives.size());
    order.resize(primitives.size());
    Building building{primitives.data(), order.data()};

    const std::unique_ptr<RTCDeviceTy, decltype(&rtcReleaseDevice)> device(rtcNewDevice("hugepages=1"),
                                                                           rtcReleaseDevice);
    if (!device) throw std::runtime_error("cannot start the tree builder");
    std::unique_ptr<RTCBVHTy, decltype(&rtcReleaseBVH)> bvh(rtcNewBVH(device.get()), rtcReleaseBVH);

    RTCBuildArguments arguments = rtcDefaultBuildArguments();
    arguments.buildQuality = RTC_BUILD_QUALITY_MEDIUM;
    arguments.maxBranchingFactor = 2;
    arguments.maxDepth = maxDepth;
    arguments.maxLeafSize = maxLeafSize;
    arguments.bvh = bvh.get();
    arguments.primitives = primitives.data();
    arguments.primitiveCount = arguments.primitiveArrayCapacity = primitives.size();
    arguments.createNode = createNode;
    arguments.setNodeChildren = setChildren;
    arguments.setNodeBounds = setBounds;
    arguments.createLeaf = createLeaf;
    arguments.userPtr = &building;
    const void* built = rtcBuildBVH(&arguments);
    if (!built) throw std::bad_alloc();

    // What is done with is released at once: a large tree is most of what memory must hold.
    primitives = std::vector<RTCBuildPrimitive>();
    reserveWhole(tree.nodes, countNodes(built));
    tree.nodes.resize(1);
    flatten(built, whole, 0, tree.nodes);
    bvh.reset();
    reserveWhole(tree.entries, order.size());
    for (const std::uint32_t element : order) tree.entries.push_back({{element}});
    return tree;
}

} // namespace yarte::trace
