#include "convert/gltf/write.h"

#include "convert/closed_mesh.h"
#include "convert/gltf/exact_store.h"
#include "convert/gltf/write_report.h"
#include "convert/gltf/write_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace yarte::convert::gltf {
namespace {

/// By material: the diameter of its largest body; 0, as of thin walls, if one of its bodies is open. Only for
/// materials that transmit: no other asks, and whether a large mesh is closed takes long to see.
std::vector<double> thicknesses(const Scene& scene, const std::vector<ShownBody>& bodies) {
    std::vector<double> result(scene.materials.size());
    for (const auto& [body, shape, geometry] : bodies) {
        double& thickness = result[body.material.index];
        if (transmits(scene.materials[body.material.index]))
            thickness = std::max(thickness, 2 * shape.scale * geometry.print.reach());
    }
    std::map<const Geometry*, bool> closed;
    for (const auto& [body, shape, geometry] : bodies) {
        double& thickness = result[body.material.index];
        if (thickness == 0) continue;
        const auto [entry, isNew] = closed.try_emplace(
            &geometry, shape.implicit.isObject() && !std::holds_alternative<Plane>(body.shape));
        if (const auto* mesh = std::get_if<yarte::Mesh>(&body.shape); mesh && isNew)
            entry->second = isClosed(scene.meshes[mesh->mesh.index]);
        if (!entry->second) thickness = 0;
    }
    return result;
}

/// By mesh: the vertices and faces that bodies show tell it all.
std::vector<bool> saidMeshes(const Scene& scene, const std::vector<ShownBody>& bodies) {
    std::vector<bool> result(scene.meshes.size());
    for (const auto& [body, shape, geometry] : bodies)
        if (const auto* mesh = std::get_if<yarte::Mesh>(&body.shape))
            result[mesh->mesh.index] = geometry.isSaid;
    return result;
}

Output outputOf(const Scene& scene, Conversion& c) {
    Output output;
    Geometries geometries(scene, c.options.chordError, output);
    const std::vector<ShownBody> bodies = shownBodies(scene, geometries);
    const std::optional<Extent> extent = extentOf(bodies);
    const WrittenMaterials materials(scene, thicknesses(scene, bodies), output);

    Json nodes = json(std::initializer_list<double>{});
    const auto addNode = [&](std::size_t node) { nodes.array().push_back(json(node)); };
    addNode(writeCamera(scene.camera, extent, output));
    std::ranges::for_each(writeLights(scene.lights, extent, output), addNode);
    std::ranges::for_each(writeBodies(bodies, materials, output), addNode);

    std::vector<bool> isUsed;
    for (std::uint32_t i = 0; i < scene.materials.size(); ++i) isUsed.push_back(materials.isUsed({i}));
    const std::vector<bool> isSaid = saidMeshes(scene, bodies);
    Json root = object({{"nodes", std::move(nodes)}});
    set(root, "extras", extrasOf(scene, isUsed, isSaid));
    output.add("scenes", std::move(root));
    report(scene, {bodies, extent, isUsed, isSaid}, c);
    return output;
}

} // namespace

std::vector<OutputFile> writeGltf(const Scene& scene, Conversion& c) {
    return outputOf(scene, c).asGltf(c.output);
}

std::vector<OutputFile> writeGlb(const Scene& scene, Conversion& c) {
    std::vector<OutputFile> files = outputOf(scene, c).asGlb(c.output);
    if (files.empty())
        c.diagnostics.error("gltf.too-large", "a .glb holds at most 4 GiB: write .gltf, which has no limit");
    return files;
}

} // namespace yarte::convert::gltf
