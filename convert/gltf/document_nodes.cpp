// Nodes, their hierarchy, and the scene that is taken.
#include "convert/gltf/document_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace yarte::convert::gltf {
namespace {

Transform readTransform(const Object& node) {
    if (node.has("matrix")) {
        for (const char* part : {"translation", "rotation", "scale"})
            if (node.has(part)) node.error("gltf.matrix-and-parts", "must not stand beside a matrix", part);
        const std::vector<double> m = node.numbers("matrix", 16);
        if (m.empty()) return {};
        // A last row other than 0 0 0 1 would be a projection, which no node has.
        constexpr double tolerance = 1e-6;
        if (std::max({std::abs(m[3]), std::abs(m[7]), std::abs(m[11]), std::abs(m[15] - 1)}) > tolerance)
            node.error("gltf.out-of-range", "the last row must be 0 0 0 1", "matrix");
        return {{m[0], m[1], m[2]}, {m[4], m[5], m[6]}, {m[8], m[9], m[10]}, {m[12], m[13], m[14]}};
    }
    std::array<double, 4> rotation{0, 0, 0, 1};
    if (const std::vector<double> q = node.numbers("rotation", 4, {-1.001, 1.001}); !q.empty()) {
        std::ranges::copy(q, rotation.begin());
        const double norm = std::hypot(std::hypot(q[0], q[1]), std::hypot(q[2], q[3]));
        if (std::abs(norm - 1) > 0.01) {
            node.error("gltf.out-of-range",
                       fmt::format("a rotation must be a quaternion of length 1, got {:.4g}", norm),
                       "rotation");
            rotation = {0, 0, 0, 1};
        }
    }
    return fromParts(node.vector("translation", {}), rotation, node.vector("scale", {1, 1, 1}));
}

std::optional<Instancing> readInstancing(const Object& node, const Document& document) {
    const auto extension = node.extension("EXT_mesh_gpu_instancing");
    if (!extension) return std::nullopt;
    const auto attributes = extension->object("attributes");
    if (!attributes) return Instancing();
    std::optional<std::size_t> count;
    const auto attribute = [&](const char* name, int components) -> std::optional<AccessorId> {
        const auto id = attributes->index(name, document.accessors.size());
        if (!id) return std::nullopt;
        const Accessor& accessor = document.accessors[*id];
        if (accessor.components != components || accessor.type == ComponentType::uint32 ||
            (count && *count != accessor.count)) {
            attributes->error(
                "gltf.bad-attribute",
                fmt::format("must have {} components and as many elements as the others", components), name);
            return std::nullopt;
        }
        count = accessor.count;
        return id;
    };
    return Instancing{attribute("TRANSLATION", 3), attribute("ROTATION", 4), attribute("SCALE", 3)};
}

std::size_t countOf(const std::optional<Object>& object, std::string_view name) {
    const Json* array = object ? object->find(name) : nullptr;
    return array ? array->items().size() : 0;
}

Node readNode(const Object& object, const Document& document, std::size_t nodeCount, std::size_t cameraCount,
              std::size_t lightCount) {
    Node node;
    node.json = &object.json();
    node.local = readTransform(object);
    node.children = object.indices("children", nodeCount);
    node.mesh = object.index("mesh", document.meshes.size());
    node.skin = object.index("skin", document.skins.size());
    node.camera = object.index("camera", cameraCount);
    node.weights = object.numbers("weights");
    if (!node.weights.empty()) {
        const std::vector<Primitive>* primitives =
            node.mesh ? &document.meshes[*node.mesh].primitives : nullptr;
        if (!primitives || primitives->empty() || primitives->front().targets.size() != node.weights.size())
            object.error("gltf.bad-reference", "must be as many as the mesh has morph targets", "weights");
    }
    if (const auto light = object.extension("KHR_lights_punctual")) {
        light->require("light");
        node.light = light->index("light", lightCount);
    }
    if (const auto visibility = object.extension("KHR_node_visibility"))
        node.isVisible = visibility->boolean("visible", true);
    node.instances = readInstancing(object, document);
    return node;
}

/// Says which nodes have two parents or are their own ancestors.
void orderNodes(const std::vector<Object>& objects, Document& document) {
    std::vector<Node>& nodes = document.nodes;
    for (std::uint32_t id = 0; id < nodes.size(); ++id) {
        for (const std::uint32_t child : nodes[id].children) {
            if (nodes[child].parent)
                objects[id].error(
                    "gltf.node-shared",
                    fmt::format("node {} is a child of node {} already", child, *nodes[child].parent),
                    "children");
            nodes[child].parent = id;
        }
    }
    std::vector<std::uint32_t>& order = document.nodeOrder;
    std::vector<bool> isReached(nodes.size());
    for (std::uint32_t id = 0; id < nodes.size(); ++id)
        if (!nodes[id].parent) order.push_back(id);
    // What has two parents was reported; visiting it once keeps this loop short.
    for (std::size_t i = 0; i < order.size(); ++i)
        for (const std::uint32_t child : nodes[order[i]].children)
            if (!isReached[child]) isReached[child] = true, order.push_back(child);
    if (order.size() == nodes.size()) return;
    for (const std::uint32_t id : order) isReached[id] = true;
    const auto first = std::ranges::find(isReached, false);
    objects[static_cast<std::size_t>(first - isReached.begin())].error(
        "gltf.node-loop", "the node is its own descendant or below one that is");
}

} // namespace

void readNodes(const Object& root, Document& document) {
    const std::vector<Object> objects = root.objects("nodes");
    const std::size_t cameras = countOf(root, "cameras"),
                      lights = countOf(root.extension("KHR_lights_punctual"), "lights");
    for (const Object& object : objects)
        document.nodes.push_back(readNode(object, document, objects.size(), cameras, lights));
    // Too many errors leave nodes unread.
    const Json* all = root.find("nodes");
    if (!all || objects.size() == all->items().size()) orderNodes(objects, document);
}

void readScene(const Object& root, Document& document) {
    const std::vector<Object> scenes = root.objects("scenes");
    document.scene = root.index("scene", scenes.size());
    if (!document.scene && !scenes.empty()) document.scene = 0;
    if (!document.scene) {
        for (std::uint32_t id = 0; id < document.nodes.size(); ++id)
            if (!document.nodes[id].parent) document.sceneNodes.push_back(id);
        return;
    }
    const Object& scene = scenes[*document.scene];
    document.sceneNodes = scene.indices("nodes", document.nodes.size());
    for (const std::uint32_t id : document.sceneNodes)
        if (document.nodes[id].parent)
            scene.error("gltf.not-a-root",
                        fmt::format("node {} is a child of node {}", id, *document.nodes[id].parent),
                        "nodes");
}

} // namespace yarte::convert::gltf
