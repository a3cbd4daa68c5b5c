#include "convert/povray/sdl/materials.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace yarte::convert::povray::sdl {
namespace {

/// A hash of numbers; what else differs is told apart by ==.
class Hash {
public:
    Hash& add(double v) {
        value_ = value_ * 1099511628211U + std::hash<double>()(v);
        return *this;
    }
    Hash& add(Colour c) { return add(c.r).add(c.g).add(c.b); }
    std::size_t value() const { return value_; }

private:
    std::size_t value_ = 14695981039346656037U;
};

std::size_t hashOf(const Layers& layers) {
    Hash hash;
    for (const Texture& t : layers) {
        const Rgbft& p = t.pigment.colour;
        hash.add(p.r).add(p.g).add(p.b).add(p.filter).add(p.transmit);
        hash.add(t.finish.ambient).add(t.finish.diffuse).add(t.finish.phong).add(t.finish.specular);
    }
    return hash.value();
}

std::size_t hashOf(const Material& m) {
    return Hash()
        .add(m.ambient)
        .add(m.diffuse)
        .add(m.specular)
        .add(m.exponent)
        .add(m.reflection)
        .add(m.transmission)
        .add(m.tint)
        .value();
}

/// What a back cannot have of its own.
void compareBack(const Material& front, const Material& back, std::vector<Loss>& losses) {
    const auto tell = [&](const char* property, Colour a, Colour b) {
        if (a == b) return;
        const double most = std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
        losses.push_back({property, Action::approximated, "the back has the front's", most});
    };
    const auto grey = [](double v) { return Colour{v, v, v}; };
    if (!isBlack(back.specular) && !isBlack(front.specular))
        tell("back: phong_size", grey(front.exponent), grey(back.exponent));
    tell("back: reflection", grey(front.reflection), grey(back.reflection));
    tell("back: transmission", transmittance(front), transmittance(back));
}

} // namespace

Style styleOf(const Object& object, const Style& outer) {
    Style style = outer;
    const Appearance& own = object.appearance;
    if (own.exact) return {nullptr, nullptr, nullptr, &*own.exact, &object};
    if (own.layers && !own.layers->empty()) style.layers = &*own.layers, style.exact = nullptr;
    if (own.backLayers && !own.backLayers->empty()) style.backLayers = &*own.backLayers;
    if (own.interior) style.interior = &*own.interior, style.medium = &object;
    return style;
}

Materials::Materials(const Model& model, Report& report)
    : defaultLayers_{model.defaultTexture}, rules_{model.ambientLight, model.languageVersion},
      report_(report), all_(model.exactMaterials) {
    for (std::uint32_t i = 0; i < all_.size(); ++i) ids_.emplace(hashOf(all_[i]), i);
}

Look Materials::lookOf(const Style& style, std::string_view kind, Span span) {
    if (style.exact && style.exact->id.index < all_.size())
        return {style.exact->id, style.exact->back, transmits(all_[style.exact->id.index])};
    const Layers& layers = style.layers ? *style.layers : defaultLayers_;
    const Material front = reduced(layers, style.interior, kind, span, false);
    Look look{add(front), {}, transmits(front)};
    if (look.isTransmissive && style.interior)
        for (const std::string& word : style.interior->ignored)
            report_.tell(kind, span, {"interior: " + word, Action::dropped, "has no counterpart"});
    if (style.backLayers) {
        const Material& back = reduced(*style.backLayers, style.interior, kind, span, true);
        std::vector<Loss> losses;
        compareBack(front, back, losses);
        for (const Loss& loss : losses) report_.tell(kind, span, loss);
        look.back = BackColours{back.ambient, back.diffuse, back.specular};
    }
    return look;
}

const Material& Materials::reduced(const Layers& layers, const Interior* interior, std::string_view kind,
                                   Span span, bool isBack) {
    const std::size_t hash = hashOf(layers);
    const std::optional<double> index = interior ? std::optional(interior->index) : std::nullopt;
    const auto [begin, end] = known_.equal_range(hash);
    for (auto known = begin; known != end; ++known)
        if (known->second.index == index && known->second.layers == layers) return known->second.material;
    Surface surface = reduce(layers, interior, rules_);
    for (Loss& loss : surface.losses) {
        if (isBack) loss.property = "back: " + loss.property;
        report_.tell(kind, span, loss);
    }
    return known_.emplace(hash, Known{layers, index, surface.material})->second.material;
}

MaterialId Materials::add(const Material& material) {
    const std::size_t hash = hashOf(material);
    const auto [begin, end] = ids_.equal_range(hash);
    for (auto id = begin; id != end; ++id)
        if (all_[id->second] == material) return {id->second};
    const auto id = static_cast<std::uint32_t>(all_.size());
    all_.push_back(material);
    ids_.emplace(hash, id);
    return {id};
}

} // namespace yarte::convert::povray::sdl
