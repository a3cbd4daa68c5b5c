#include "convert/gltf/hierarchy.h"

#include "convert/gltf/accessor.h"

#include <algorithm>
#include <fmt/format.h>

namespace yarte::convert::gltf {

Hierarchy::Hierarchy(const Document& document) : worlds_(document.nodes.size()) {
    for (const std::uint32_t id : document.nodeOrder) {
        const Node& node = document.nodes[id];
        worlds_[id] = node.parent ? worlds_[*node.parent] * node.local : node.local;
    }
    std::vector<bool> isShown(document.nodes.size());
    std::vector<std::uint32_t> open(document.sceneNodes.rbegin(), document.sceneNodes.rend());
    while (!open.empty()) { // depth first, without recursion: a file may be deep
        const std::uint32_t id = open.back();
        open.pop_back();
        const Node& node = document.nodes[id];
        inScene_.push_back(id);
        isShown[id] = node.isVisible && (!node.parent || isShown[*node.parent]);
        if (isShown[id]) shown_.push_back(id);
        open.insert(open.end(), node.children.rbegin(), node.children.rend());
    }
}

/// All in one place: a file of some bytes must not ask for a gigabyte.
constexpr std::size_t maxInstancesWithoutBytes = 1 << 16;

std::optional<std::vector<Transform>> instancesOf(std::uint32_t id, const Hierarchy& hierarchy,
                                                  Content& content) {
    const Node& node = content.document().nodes[id];
    const Transform& world = hierarchy.world(id);
    if (!node.instances) return std::vector{world};
    const auto& [translation, rotation, scale] = *node.instances;
    const auto first = translation ? translation : rotation ? rotation : scale;
    if (!first) return std::vector{world};
    const Accessor& places = content.document().accessors[*first];
    const std::size_t count = places.count;
    if (!places.view && count > maxInstancesWithoutBytes) {
        content.errors().report("gltf.too-large",
                                fmt::format("{} instances, and no buffer says where", count), *places.json);
        return std::nullopt;
    }
    std::vector<Vec3> translations, scales; // empty: as if there were none
    std::vector<double> rotations;
    const auto take = [](auto&& read, auto& values) {
        if (read) values = std::move(*read);
        return read.has_value();
    };
    if ((translation && !take(readVectors(content, *translation), translations)) ||
        (rotation && !take(readNumbers(content, *rotation), rotations)) ||
        (scale && !take(readVectors(content, *scale), scales)))
        return std::nullopt;
    std::vector<Transform> worlds(count);
    for (std::size_t i = 0; i < count; ++i) {
        std::array<double, 4> q{0, 0, 0, 1};
        if (rotation) std::copy_n(rotations.begin() + static_cast<std::ptrdiff_t>(4 * i), 4, q.begin());
        if (q == std::array<double, 4>{}) {
            content.errors().report("gltf.out-of-range", "a rotation must be a quaternion of length 1, got 0",
                                    *content.document().accessors[*rotation].json);
            return std::nullopt;
        }
        worlds[i] =
            world * fromParts(translation ? translations[i] : Vec3(), q, scale ? scales[i] : Vec3{1, 1, 1});
    }
    return worlds;
}

std::optional<std::vector<Transform>> jointsOf(const Skin& skin, const Hierarchy& hierarchy,
                                               Content& content) {
    std::vector<Transform> joints;
    for (const std::uint32_t joint : skin.joints) joints.push_back(hierarchy.world(joint));
    if (!skin.inverseBindMatrices) return joints;
    const auto numbers = readNumbers(content, *skin.inverseBindMatrices);
    if (!numbers) return std::nullopt;
    for (std::size_t j = 0; j < joints.size(); ++j) {
        const double* m = numbers->data() + 16 * j;
        joints[j] =
            joints[j] *
            Transform{{m[0], m[1], m[2]}, {m[4], m[5], m[6]}, {m[8], m[9], m[10]}, {m[12], m[13], m[14]}};
    }
    return joints;
}

} // namespace yarte::convert::gltf
