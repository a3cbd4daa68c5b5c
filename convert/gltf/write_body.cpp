#include "convert/gltf/write_body.h"

#include "convert/gltf/exact_store.h"
#include "convert/gltf/write_node.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace yarte::convert::gltf {
std::vector<ShownBody> shownBodies(const Scene& scene, Geometries& geometries) {
    std::vector<ShownBody> result;
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        const Body& body = scene.bodies[i];
        ShownShape shape = shownShape(body, i);
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
    std::optional<std::pair<Vec3, Vec3>> box;
    for (const auto& [body, shape, geometry] : bodies)
        for (int corner = 0; corner < 8; ++corner) {
            const Vec3 v = shape.world().point({corner & 1 ? geometry.high.x : geometry.low.x,
                                                corner & 2 ? geometry.high.y : geometry.low.y,
                                                corner & 4 ? geometry.high.z : geometry.low.z});
            if (!box) box = {v, v};
            box->first = {std::min(box->first.x, v.x), std::min(box->first.y, v.y),
                          std::min(box->first.z, v.z)};
            box->second = {std::max(box->second.x, v.x), std::max(box->second.y, v.y),
                           std::max(box->second.z, v.z)};
        }
    if (!box) return std::nullopt;
    const Vec3 diagonal = box->second - box->first;
    return Extent{box->first + diagonal / 2, length(diagonal) / 2};
}

} // namespace yarte::convert::gltf
