#include "convert/gltf/read_material.h"

#include "yarte/scene/check.h"

#include <fmt/format.h>

#include <algorithm>

namespace yarte::convert::gltf {
namespace {

std::span<const Json> materialsOf(const Asset& asset) {
    const Json* all = asset.root().find("materials");
    return all ? all->items() : std::span<const Json>();
}

} // namespace

Materials::Materials(Asset& asset, Ledger& ledger)
    : asset_(asset), ledger_(ledger), textures_(asset, ledger) {
    for (const Json& material : materialsOf(asset)) {
        const Json* used = material.find("extensions");
        if (!used) continue;
        extensions_.ior |= used->find("KHR_materials_ior") != nullptr;
        extensions_.specular |= used->find("KHR_materials_specular") != nullptr;
        extensions_.volume |= used->find("KHR_materials_volume") != nullptr;
    }
}

std::size_t Materials::indexOf(std::optional<std::uint32_t> material, const Tint& tint) {
    const auto found = std::ranges::find_if(
        all_, [&](const Entry& entry) { return entry.source == material && entry.tint == tint; });
    if (found != all_.end()) return static_cast<std::size_t>(found - all_.begin());
    all_.push_back(read(material, tint));
    return all_.size() - 1;
}

Materials::Entry Materials::read(std::optional<std::uint32_t> id, const Tint& tint) {
    if (!id) {
        PbrMaterial standard;
        standard.base = tint.colour;
        return {id, tint, toPhong(standard), {}};
    }
    const Json& json = materialsOf(asset_)[*id];
    const std::string where = fmt::format("/materials/{}", *id);
    const PbrMaterial pbr = readPbr(Object(json, asset_.errors()), tint, textures_);
    const Exact<Material> exact = exactMaterial(json.find("extras"), pbr, extensions_);
    if (exact.state == Stored::valid) return {id, tint, exact.value, exact.order};
    if (!exact.why.empty()) ledger_.add({where, "exact values in extras", Action::dropped, exact.why, {}});
    json.change(Fate::read, Fate::approximated);
    Entry entry{id, tint, toPhong(pbr), exact.order};
    for (const Problem& problem : check(entry.material))
        asset_.errors().report(problem.code, problem.message, json);
    return entry;
}

} // namespace yarte::convert::gltf
