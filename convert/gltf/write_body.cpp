#include "convert/gltf/write_body.h"

#include "convert/gltf/exact_store.h"
#include "convert/gltf/write_node.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace yarte::convert::gltf {

bool isPlane(const Body& body) { return std::holds_alternative<Plane>(body.shape); }

std::vector<ShownBody> shownBodies(const Scene& scene, Geometries& geometries) {
    std::vector<ShownBody> result;
    const bool hasPlanes = std::ranges::any_of(scene.bodies, isPlane);
    const Surround around = hasPlanes ? surroundOf(scene) : Surround{};
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        const Body& body = scene.bodies[i];
        ShownShape shape = shownShape(body, i, around);
        const Geometry& geometry = geometries.of(body, shape);
        result.push_back({body, std::move(shape), geometry});
    }
    return result;
}

std::vector<std::size_t> writeBodies(const std::vector<ShownBody>& bodies, const WrittenMaterials& materials,
                                     Output& output) {
    std::vector<std::size_t> nodes;
    std::map<std::pair<const Geometry*, std::size_t>, std::size_t> meshes;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const auto& [body, shape, geometry] = bodies[i];
        Json node = object({{"name", json(fmt::format("{} {}", shape.kind, i + 1))}});
        setTransform(node, shape.axes, shape.scale, shape.middle);
        const std::size_t material = materials.indexOf(body.material);
        const auto [mesh, isNew] = meshes.try_emplace({&geometry, material}, meshes.size());
        if (isNew) {
            Json primitive = geometry.primitive;
            set(primitive, "material", json(material));
            output.add("meshes",
                       object({{"name", json(shape.key)}, {"primitives", array({std::move(primitive)})}}));
        }
        set(node, "mesh", json(mesh->second));
        if (geometry.implicit) {
            output.use(rigidBodies);
            set(node, "extensions",
                object(
                    {{rigidBodies,
                      object({{"collider",
                               object({{"geometry", object({{"shape", json(*geometry.implicit)}})}})}})}}));
        }
        set(node, "extras", extrasOf(body, i, shape.world(), geometry.print));
        nodes.push_back(output.add("nodes", std::move(node)));
    }
    return nodes;
}

std::optional<Extent> extentOf(const std::vector<ShownBody>& bodies) {
    if (bodies.empty()) return std::nullopt;
    Extent extent;
    const auto isShownPlane = [](const ShownBody& shown) { return isPlane(shown.body); };
    const bool hasPlanesOnly = std::ranges::all_of(bodies, isShownPlane);
    for (const auto& [body, shape, geometry] : bodies) {
        if (isPlane(body)) {
            if (hasPlanesOnly) extent.add(shape.middle);
            continue;
        }
        Extent box;
        box.add(geometry.low), box.add(geometry.high);
        extent.addPlaced(box, shape.world());
    }
    return extent;
}

} // namespace yarte::convert::gltf
