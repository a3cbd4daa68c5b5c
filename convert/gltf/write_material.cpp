#include "convert/gltf/write_material.h"

#include "convert/gltf/exact_store.h"

#include <fmt/format.h>

#include <algorithm>

namespace yarte::convert::gltf {
namespace {

double unit(double value) { return std::clamp(value, 0.0, 1.0); }

/// Rounding may leave a value a little outside of what glTF allows.
PbrMaterial allowed(PbrMaterial m) {
    m.base = {unit(m.base.r), unit(m.base.g), unit(m.base.b)};
    for (double* factor : {&m.metallic, &m.roughness, &m.transmission, &m.specular}) *factor = unit(*factor);
    return m;
}

class MaterialWriter {
public:
    explicit MaterialWriter(Output& output) : output_(output) {}

    Json write(const PbrMaterial& m) && {
        Json material = object(
            {{"pbrMetallicRoughness", object({{"baseColorFactor", json({m.base.r, m.base.g, m.base.b, 1})},
                                              {"metallicFactor", json(m.metallic)},
                                              {"roughnessFactor", json(m.roughness)}})}});
        const double strength = std::max(1.0, maxComponent(m.emissive));
        if (!isBlack(m.emissive)) set(material, "emissiveFactor", json(m.emissive * (1 / strength)));
        if (strength > 1)
            extend("KHR_materials_emissive_strength", object({{"emissiveStrength", json(strength)}}));
        const PbrMaterial plain;
        if (m.ior != plain.ior) extend("KHR_materials_ior", object({{"ior", json(m.ior)}}));
        if (m.specular != plain.specular || m.specularColour != plain.specularColour)
            extend("KHR_materials_specular", object({{"specularFactor", json(m.specular)},
                                                     {"specularColorFactor", json(m.specularColour)}}));
        if (m.transmission > 0)
            extend("KHR_materials_transmission", object({{"transmissionFactor", json(m.transmission)}}));
        if (m.thickness > 0) extend("KHR_materials_volume", object({{"thicknessFactor", json(m.thickness)}}));
        // YARTE draws both sides; of a volume, whose surface is closed, glTF wants one.
        if (m.thickness == 0) set(material, "doubleSided", Json(true));
        if (!extensions_.members().empty()) set(material, "extensions", std::move(extensions_));
        return material;
    }

private:
    void extend(const char* name, Json extension) {
        output_.use(name);
        set(extensions_, name, std::move(extension));
    }

    Output& output_;
    Json extensions_ = object({});
};

} // namespace

WrittenMaterials::WrittenMaterials(const Scene& scene, const std::vector<double>& thickness, Output& output)
    : indices_(scene.materials.size()) {
    std::vector<bool> used(scene.materials.size());
    for (const Body& body : scene.bodies) used[body.material.index] = true;
    for (std::size_t i = 0; i < used.size(); ++i) {
        if (!used[i]) continue;
        PbrMaterial shown = allowed(toPbr(scene.materials[i]));
        if (shown.thickness > 0) shown.thickness = thickness[i];
        Json material = MaterialWriter(output).write(shown);
        set(material, "name", json(fmt::format("material {}", i + 1)));
        set(material, "extras", extrasOf(scene.materials[i], i, shown));
        indices_[i] = output.add("materials", std::move(material));
    }
}

} // namespace yarte::convert::gltf
