#include "convert/gltf/document.h"

#include "convert/gltf/document_parts.h"
#include "yarte/base/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace yarte::convert::gltf {
namespace {

/// What a file may require: extensions that are read, and those that change no more than a surface's look,
/// whose loss the ledger tells.
constexpr std::array<std::string_view, 25> readable{
    "EXT_mesh_gpu_instancing",
    "KHR_animation_pointer",
    "KHR_implicit_shapes",
    "KHR_lights_punctual",
    "KHR_materials_anisotropy",
    "KHR_materials_clearcoat",
    "KHR_materials_diffuse_transmission",
    "KHR_materials_dispersion",
    "KHR_materials_emissive_strength",
    "KHR_materials_ior",
    "KHR_materials_iridescence",
    "KHR_materials_pbrSpecularGlossiness",
    "KHR_materials_sheen",
    "KHR_materials_specular",
    "KHR_materials_transmission",
    "KHR_materials_unlit",
    "KHR_materials_variants",
    "KHR_materials_volume",
    "KHR_mesh_quantization",
    "KHR_node_hoverability",
    "KHR_node_selectability",
    "KHR_node_visibility",
    "KHR_texture_transform",
    "KHR_xmp",
    "KHR_xmp_json_ld",
};

void checkVersion(const Object& root) {
    root.require("asset");
    const std::optional<Object> asset = root.object("asset");
    if (!asset) return;
    asset->require("version");
    const std::string name = asset->has("minVersion") ? "minVersion" : "version";
    const std::string version = asset->text(name, "2.0");
    // 2.1 is 2.0 with more in it; a file that cannot do without says so in minVersion.
    if (name == "minVersion" ? version != "2.0" : !version.starts_with("2."))
        asset->error("gltf.version", fmt::format("must be 2.0, got {}", inQuotes(version)), name);
}

} // namespace

void checkRequiredExtensions(const Object& root) {
    const Json* required = root.find("extensionsRequired");
    std::size_t index = 0;
    for (const Json& item : required ? required->items() : std::span<const Json>()) {
        item.mark(Fate::read);
        const std::string place = fmt::format("extensionsRequired/{}", index++);
        const std::string* name = item.text();
        if (!name)
            root.error("gltf.wrong-type", "must be the name of an extension", place);
        else if (std::ranges::find(readable, *name) == readable.end())
            root.error(
                "gltf.extension-required",
                fmt::format("the file requires the extension {}, which is not supported", printable(*name)),
                place);
    }
}

std::optional<Document> readDocument(const Json& json, Errors& errors) {
    const Object root(json, errors);
    checkVersion(root);
    checkRequiredExtensions(root);
    if (errors.any()) return std::nullopt;
    Document document;
    readBuffers(root, document, errors);
    readMeshes(root, document);
    readSkins(root, document);
    readNodes(root, document);
    if (!errors.any()) readScene(root, document);
    if (errors.any()) return std::nullopt;
    return document;
}

} // namespace yarte::convert::gltf
