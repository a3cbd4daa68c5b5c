// Materials of a glTF file as Phong materials.
#pragma once

#include "convert/gltf/exact.h"
#include "convert/gltf/pbr.h"

namespace yarte::convert::gltf {

class Materials {
public:
    Materials(Asset&, Ledger&);

    /// Index into `all` of the material (none: glTF's default) with that tint.
    std::size_t indexOf(std::optional<std::uint32_t> material, const Tint&);

    struct Entry {
        std::optional<std::uint32_t> source;
        Tint tint;
        Material material;
        std::optional<std::size_t> order; ///< as Exact::order
    };
    const std::vector<Entry>& all() const { return all_; }

private:
    Entry read(std::optional<std::uint32_t> material, const Tint&);

    Asset& asset_;
    Ledger& ledger_;
    Textures textures_;
    MaterialExtensions extensions_;
    std::vector<Entry> all_;
};

} // namespace yarte::convert::gltf
