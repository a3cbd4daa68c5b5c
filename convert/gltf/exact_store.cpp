#include "convert/gltf/exact_store.h"

#include "convert/gltf/exact_text.h"
#include "convert/gltf/percent.h"
#include "convert/gltf/write_json.h"

namespace yarte::convert::gltf {
namespace {

Json ours(Json record) {
    Json extras = object({});
    set(extras, "yarte", std::move(record));
    return extras;
}

} // namespace

Json extrasOf(const Body& body, std::size_t order, const Transform& world, const GeometryPrint& print) {
    Json record = object({{"body", json(order)},
                          {"text", json(text(body))},
                          {"world", json(world)},
                          {"geometry", json(print.text())}});
    if (const auto* mesh = std::get_if<yarte::Mesh>(&body.shape))
        set(record, "mesh", json(std::size_t{mesh->mesh.index}));
    return ours(std::move(record));
}

Json extrasOf(const Light& light, std::size_t order, const ShownLight& shown) {
    return ours(object({{"light", json(order)},
                        {"text", json(text(light))},
                        {"position", json(light.position)},
                        {"colour", json(shown.colour)},
                        {"intensity", json(shown.intensity)}}));
}

Json extrasOf(const Camera& camera, const Transform& world, double yfov, double aspectRatio) {
    return ours(object({{"camera", json(std::size_t{0})},
                        {"text", json(text(camera))},
                        {"world", json(world)},
                        {"yfov", json(yfov)},
                        {"aspectRatio", json(aspectRatio)}}));
}

Json extrasOf(const Material& material, std::size_t order, const PbrMaterial& shown) {
    return ours(object(
        {{"material", json(order)}, {"text", json(text(material))}, {"shown", Json(shownValues(shown))}}));
}

Json extrasOf(const Scene& scene, const std::vector<bool>& isUsed, const std::vector<bool>& isSaid) {
    Json materials{Json::Array()}, meshes{Json::Array()};
    for (std::size_t i = 0; i < scene.materials.size(); ++i)
        if (!isUsed[i])
            materials.array().push_back(
                object({{"material", json(i)}, {"text", json(text(scene.materials[i]))}}));
    for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
        Json mesh = object({{"path", json(percentEncoded(scene.meshes[i].path))}});
        if (!isSaid[i]) set(mesh, "pmf", json(meshText(scene.meshes[i])));
        meshes.array().push_back(std::move(mesh));
    }
    Json record = object(
        {{"scene", json(1.0)}, {"text", json(settingsText(scene))}, {"lights", json(scene.lights.size())}});
    set(record, "unusedMaterials", std::move(materials));
    set(record, "meshes", std::move(meshes));
    return ours(std::move(record));
}

std::vector<Json::Member> shownValues(const PbrMaterial& m) {
    return {{"base", json(m.base)},
            {"metallic", json(m.metallic)},
            {"roughness", json(m.roughness)},
            {"emissive", json(m.emissive)},
            {"transmission", json(m.transmission)},
            {"alpha", json(m.alpha)},
            {"unlit", json(m.unlit ? 1.0 : 0.0)},
            {"ior", json(m.ior)},
            {"specular", json(m.specular)},
            {"specularColour", json(m.specularColour)},
            {"thickness", json(m.thickness)}};
}

} // namespace yarte::convert::gltf
