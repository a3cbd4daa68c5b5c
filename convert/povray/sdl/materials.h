// The materials of a scene that is being made: equal ones are one.
#pragma once

#include "convert/povray/sdl/reduce_layers.h"

#include <unordered_map>

namespace yarte::convert::povray::sdl {

/// An object's appearance with what it has from the unions around it.
struct Style {
    const Layers* layers = nullptr; ///< null: the default texture
    const Layers* backLayers = nullptr;
    const Interior* interior = nullptr;
    const ExactMaterial* exact = nullptr;
    const Object* medium = nullptr; ///< whose interior it is: parts that have it in common are one medium
};

/// `object` within something that looks like `outer`.
Style styleOf(const Object& object, const Style& outer);

struct Look {
    MaterialId material;
    std::optional<BackColours> back;
    bool isTransmissive = false;
    friend bool operator==(const Look&, const Look&) = default;
};

class Materials {
public:
    /// Begins with the model's exact materials, used or not.
    Materials(const Model&, Report&);

    /// What is lost is told of the first object that has the appearance.
    Look lookOf(const Style&, std::string_view kind, Span);

    const Material& operator[](MaterialId id) const { return all_[id.index]; }
    std::vector<Material> take() && { return std::move(all_); }

private:
    struct Known {
        Layers layers;
        std::optional<double> index;
        Material material;
    };
    const Material& reduced(const Layers&, const Interior*, std::string_view kind, Span, bool isBack);
    MaterialId add(const Material&);

    const Layers defaultLayers_;
    const TextureRules rules_;
    Report& report_;
    std::unordered_multimap<std::size_t, Known> known_;
    std::vector<Material> all_;
    std::unordered_multimap<std::size_t, std::uint32_t> ids_;
};

} // namespace yarte::convert::povray::sdl
