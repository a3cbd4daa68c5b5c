#include "convert/gltf/pbr.h"

#include <algorithm>

namespace yarte::convert::gltf {
namespace {

/// The fourth number of a colour with alpha.
double alphaOf(const Object& object, std::string_view name) {
    const std::vector<double> v = object.numbers(name, 4, unitRange);
    return v.empty() ? 1 : v[3];
}

Colour colourOf(const Object& object, std::string_view name) {
    const std::vector<double> v = object.numbers(name, 4, unitRange);
    return v.empty() ? Colour{1, 1, 1} : Colour{v[0], v[1], v[2]};
}

void readMetallicRoughness(const Object& pbr, Textures& textures, PbrMaterial& m, bool& isTextured) {
    const ImageAverage base = textures.average(pbr, "baseColorTexture");
    m.base = colourOf(pbr, "baseColorFactor") * base.linear;
    m.alpha = alphaOf(pbr, "baseColorFactor") * base.alpha;
    isTextured = pbr.has("baseColorTexture");
    const ImageAverage rough = textures.average(pbr, "metallicRoughnessTexture");
    m.roughness = pbr.number("roughnessFactor", 1, unitRange) * rough.raw.g;
    m.metallic = pbr.number("metallicFactor", 1, unitRange) * rough.raw.b;
}

/// Archived KHR_materials_pbrSpecularGlossiness: reflectance above that of common dielectrics is taken for
/// metal, in proportion to what is diffuse.
void readSpecularGlossiness(const Object& pbr, Textures& textures, PbrMaterial& m, bool& isTextured) {
    const ImageAverage diffuseImage = textures.average(pbr, "diffuseTexture");
    const ImageAverage specularImage = textures.average(pbr, "specularGlossinessTexture");
    const Colour f0 = pbr.colour("specularFactor", {1, 1, 1}) * specularImage.linear;
    const Colour diffuse = colourOf(pbr, "diffuseFactor") * diffuseImage.linear * (1 - maxComponent(f0));
    m.alpha = alphaOf(pbr, "diffuseFactor") * diffuseImage.alpha;
    isTextured = pbr.has("diffuseTexture");
    m.roughness = 1 - pbr.number("glossinessFactor", 1, unitRange) * specularImage.alpha;
    constexpr double dielectric = 0.04;
    const double metal = std::max(0.0, maxComponent(f0) - dielectric), scattered = maxComponent(diffuse);
    m.metallic = metal > 0 ? metal / (metal + scattered) : 0;
    m.base = diffuse + f0 * m.metallic;
    m.specularColour = f0 * (1 / dielectric);
}

void readVolumeAndSpecular(const Object& material, Textures& textures, PbrMaterial& m) {
    if (const auto ior = material.extension("KHR_materials_ior")) {
        m.ior = ior->number("ior", 1.5, notNegative);
        if (m.ior != 0 && m.ior < 1) {
            ior->error("gltf.out-of-range", "must be 0 or at least 1", "ior");
            m.ior = 1.5;
        }
    }
    if (const auto transmission = material.extension("KHR_materials_transmission"))
        m.transmission = transmission->number("transmissionFactor", 0, unitRange) *
                         textures.average(*transmission, "transmissionTexture").raw.r;
    if (const auto volume = material.extension("KHR_materials_volume"))
        m.thickness = volume->number("thicknessFactor", 0, notNegative);
    if (const auto specular = material.extension("KHR_materials_specular")) {
        m.specular = specular->number("specularFactor", 1, unitRange) *
                     textures.average(*specular, "specularTexture").alpha;
        m.specularColour = specular->colour("specularColorFactor", {1, 1, 1}, notNegative) *
                           textures.average(*specular, "specularColorTexture").linear;
    }
}

/// How alphaMode reads the mean alpha: what MASK leaves of a texture is its mean coverage.
double coverage(const Object& material, double alpha, bool isTextured) {
    const std::string mode = material.text("alphaMode", "OPAQUE");
    const double cutoff = material.number("alphaCutoff", 0.5, notNegative);
    if (mode == "BLEND") return alpha;
    if (mode == "MASK") return isTextured ? alpha : alpha >= cutoff;
    if (mode != "OPAQUE") material.error("gltf.out-of-range", "must be OPAQUE, MASK or BLEND", "alphaMode");
    return 1;
}

} // namespace

PbrMaterial readPbr(const Object& material, const Tint& tint, Textures& textures) {
    PbrMaterial m;
    bool isTextured = false;
    const auto metallic = material.object("pbrMetallicRoughness");
    if (const auto glossiness = material.extension("KHR_materials_pbrSpecularGlossiness"))
        readSpecularGlossiness(*glossiness, textures, m, isTextured);
    else if (metallic)
        readMetallicRoughness(*metallic, textures, m, isTextured);
    m.base = m.base * tint.colour;
    m.alpha = coverage(material, m.alpha * tint.alpha, isTextured || tint.alpha != 1);

    const auto strength = material.extension("KHR_materials_emissive_strength");
    m.emissive = material.colour("emissiveFactor", {}) *
                 textures.average(material, "emissiveTexture").linear *
                 (strength ? strength->number("emissiveStrength", 1, notNegative) : 1.0);
    readVolumeAndSpecular(material, textures, m);
    m.unlit = material.extension("KHR_materials_unlit").has_value();
    return m;
}

} // namespace yarte::convert::gltf
