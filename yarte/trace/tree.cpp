#include "yarte/trace/tree.h"

#include "yarte/base/huge_pages.h"

#include <embree3/rtcore.h>

#include <limits>
#include <memory>
#include <new>
#include <stdexcept>

namespace yarte::trace {
namespace {

constexpr unsigned maxDepth = 56;
constexpr unsigned maxLeafSize = 4;

/// The tree as Embree's callbacks make it, in Embree's arena; flattened afterwards.
struct BuiltNode {
    RTCBounds childBounds[2];
    BuiltNode* children[2] = {nullptr, nullptr};
    const RTCBuildPrimitive* primitives = nullptr; ///< of a leaf
    std::size_t primitiveCount = 0;
};

void* allocate(RTCThreadLocalAllocator allocator) {
    return new (rtcThreadLocalAlloc(allocator, sizeof(BuiltNode), alignof(BuiltNode))) BuiltNode;
}

void* createNode(RTCThreadLocalAllocator allocator, unsigned, void*) { return allocate(allocator); }

void setChildren(void* node, void** children, unsigned count, void*) {
    for (unsigned i = 0; i < count; ++i)
        static_cast<BuiltNode*>(node)->children[i] = static_cast<BuiltNode*>(children[i]);
}

void setBounds(void* node, const RTCBounds** bounds, unsigned count, void*) {
    for (unsigned i = 0; i < count; ++i) static_cast<BuiltNode*>(node)->childBounds[i] = *bounds[i];
}

void* createLeaf(RTCThreadLocalAllocator allocator, const RTCBuildPrimitive* primitives, std::size_t count,
                 void*) {
    auto* leaf = static_cast<BuiltNode*>(allocate(allocator));
    leaf->primitives = primitives, leaf->primitiveCount = count;
    return leaf;
}

/// One step beyond the nearest float: outside whatever rounding happened on the way.
float roundDown(double v) {
    return std::nextafter(static_cast<float>(v), -std::numeric_limits<float>::infinity());
}
float roundUp(double v) {
    return std::nextafter(static_cast<float>(v), std::numeric_limits<float>::infinity());
}

class Flattener {
public:
    explicit Flattener(Tree& tree) : tree_(tree) {}

    /// Writes `built`, with the given box, to nodes[at], and what is below it behind the nodes there are.
    void write(std::size_t at, const BuiltNode& built, const RTCBounds& box) {
        TreeNode node{{box.lower_x, box.lower_y, box.lower_z}, 0, {box.upper_x, box.upper_y, box.upper_z}, 0};
        if (built.primitives) {
            node.first = static_cast<std::uint32_t>(tree_.entries.size());
            node.count = static_cast<std::uint32_t>(built.primitiveCount);
            for (std::size_t i = 0; i < built.primitiveCount; ++i)
                tree_.entries.push_back({{built.primitives[i].primID}});
            std::sort(
                tree_.entries.end() - node.count, tree_.entries.end(),
                [](const TreeEntry& a, const TreeEntry& b) { return a.element.index < b.element.index; });
            tree_.nodes[at] = node;
            return;
        }
        const std::size_t left = tree_.nodes.size();
        node.first = static_cast<std::uint32_t>(left);
        tree_.nodes[at] = node;
        tree_.nodes.resize(left + 2);
        write(left, *built.children[0], built.childBounds[0]);
        write(left + 1, *built.children[1], built.childBounds[1]);
    }

private:
    Tree& tree_;
};

} // namespace

Tree buildTree(std::span<const Bounds> elements) {
    Tree tree;
    if (elements.empty()) return tree;
    Bounds all;
    for (const Bounds& element : elements) all.add(element);
    tree.centre = (all.low + all.high) / 2;
    tree.radius = length(all.high - all.low) / 2;
    const double margin = boxMargin * tree.radius;
    const Vec3 widen{margin, margin, margin};
    const auto boxOf = [&](const Bounds& b, unsigned id) -> RTCBuildPrimitive {
        const Vec3 low = b.low - tree.centre - widen, high = b.high - tree.centre + widen;
        return {roundDown(low.x), roundDown(low.y), roundDown(low.z), 0,
                roundUp(high.x),  roundUp(high.y),  roundUp(high.z),  id};
    };
    std::vector<RTCBuildPrimitive> primitives;
    reserveWhole(primitives, elements.size());
    for (std::size_t i = 0; i < elements.size(); ++i)
        primitives.push_back(boxOf(elements[i], static_cast<unsigned>(i)));
    const RTCBuildPrimitive root = boxOf(all, 0);
    const RTCBounds whole{root.lower_x, root.lower_y, root.lower_z, 0,
                          root.upper_x, root.upper_y, root.upper_z, 0};

    const std::unique_ptr<RTCDeviceTy, decltype(&rtcReleaseDevice)> device(rtcNewDevice("hugepages=1"),
                                                                           rtcReleaseDevice);
    if (!device) throw std::runtime_error("cannot start the tree builder");
    const std::unique_ptr<RTCBVHTy, decltype(&rtcReleaseBVH)> bvh(rtcNewBVH(device.get()), rtcReleaseBVH);

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
    const auto* built = static_cast<const BuiltNode*>(rtcBuildBVH(&arguments));
    if (!built) throw std::bad_alloc();

    tree.nodes.resize(1);
    reserveWhole(tree.entries, elements.size());
    Flattener(tree).write(0, *built, whole);
    return tree;
}

} // namespace yarte::trace
