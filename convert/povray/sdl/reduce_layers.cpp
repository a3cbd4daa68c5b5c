#include "convert/povray/sdl/reduce_layers.h"

#include "convert/povray/sdl/reflectance.h"
#include "yarte/base/number.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace yarte::convert::povray::sdl {
namespace {

double least(Colour c) { return std::min({c.r, c.g, c.b}); }
double mean(Colour c) { return (c.r + c.g + c.b) / 3; }
/// How far a channel is from `grey`.
double distance(Colour c, double grey) { return std::max(maxComponent(c) - grey, grey - least(c)); }

/// A colour between white and `tint`.
Colour tinted(Colour tint, double by) { return Colour{1 - by, 1 - by, 1 - by} + tint * by; }

/// How much of a layer's own colour shows, and what it lets through of what lies below.
struct Transparency {
    double opacity = 1;
    Colour passes;
};

/// Measured with POV-Ray 3.7: before version 3.7 a filter takes only as much from the layer's own colour as
/// its brightest channel lets through; up to 3.1 layers above another ignore their colour there and as
/// filter.
Transparency transparencyOf(const Rgbft& p, double version, bool isLowest) {
    const double through = p.filter + p.transmit;
    if (version <= 3.1 && !isLowest) return {1 - through, {through, through, through}};
    const Colour rgb{p.r, p.g, p.b};
    const double brightest = version < 3.7 ? p.filter * maxComponent(rgb) + p.transmit : through;
    return {1 - brightest, rgb * p.filter + Colour{1, 1, 1} * p.transmit};
}

/// Highlights of different width: the strongest one's exponent is nearest to what is seen.
class Highlights {
public:
    void add(Colour strength, double exponent) {
        if (isBlack(strength)) return;
        sum_ += strength;
        isMixed_ |= strongest_ > 0 && exponent != exponent_;
        if (maxComponent(strength) <= strongest_) return;
        strongest_ = maxComponent(strength);
        exponent_ = exponent;
    }
    Colour sum() const { return sum_; }
    double exponent() const { return exponent_; }
    bool isMixed() const { return isMixed_; }

private:
    Colour sum_;
    double exponent_ = 1, strongest_ = 0;
    bool isMixed_ = false;
};

class Reduction {
public:
    Reduction(const Interior* interior, const TextureRules& rules) : interior_(interior), rules_(rules) {}

    Surface reduce(const Layers& layers) {
        for (const Texture& texture : layers)
            if (texture.finish.index) index_ = *texture.finish.index;
        if (interior_) index_ = interior_->index;
        for (std::size_t i = layers.size(); i-- > 0;) {
            add(layers[i], i == 0);
            if (isBlack(filter_)) break; // what lies below an opaque layer is not even mirrored
        }
        if (layers.size() > 1) reduceLayers();
        finish();
        return std::move(surface_);
    }

private:
    void tell(std::string property, Action action, std::string detail, std::optional<double> bound = {}) {
        surface_.losses.push_back({std::move(property), action, std::move(detail), bound});
    }

    void add(const Texture& texture, bool isLowest) {
        reportOmitted(texture);
        const Finish& f = texture.finish;
        const Rgbft& p = texture.pigment.colour;
        const Colour rgb{p.r, p.g, p.b};
        const Transparency t = transparencyOf(p, rules_.languageVersion, isLowest);
        const Colour own = filter_ * rgb * t.opacity;
        surface_.material.ambient += own * (f.ambient * rules_.ambientLight + f.emission);
        surface_.material.diffuse += own * f.diffuse;
        addHighlights(f, rgb);
        const double reflected = addReflection(f, rgb);
        filter_ = filter_ * t.passes * (f.conserveEnergy ? 1 - reflected : 1);
        isDark_ |= t.opacity < 0;
    }

    void addHighlights(const Finish& f, Colour rgb) {
        const Colour tint = filter_ * tinted(rgb, f.metallic);
        if (f.phong != 0) highlights_.add(tint * f.phong, f.phongSize);
        if (f.specular != 0) {
            highlights_.add(tint * f.specular, phongExponent(f.roughness));
            tell("specular", Action::approximated,
                 fmt::format("Blinn's highlight of roughness {} as Phong's, 1/(4*roughness)",
                             printNumber(f.roughness)));
        }
        if (f.metallic != 0 && (f.phong != 0 || f.specular != 0))
            tell("metallic", Action::approximated, "the highlight's tint does not fade at grazing angles");
        if (f.brilliance != 1 && f.diffuse != 0)
            tell("brilliance", Action::dropped, fmt::format("{} becomes 1", printNumber(f.brilliance)));
    }

    /// The layer's mean reflectance. Upper layers do not dim it.
    double addReflection(const Finish& f, Colour rgb) {
        if (isBlack(f.reflectionMin) && isBlack(f.reflectionMax)) return 0;
        const double share = f.reflectionFresnel ? meanFresnel(index_) : meanFalloff(f.reflectionFalloff);
        const Colour tint = tinted(rgb, f.reflectionMetallic);
        const Colour low = f.reflectionMin * tint, high = f.reflectionMax * tint;
        const double grey = mean(low * (1 - share) + high * share);
        if (f.reflectionMetallic != 0)
            tell("reflection", Action::approximated,
                 "metallic: tinted by the pigment at all angles, then grey");
        if (const double off = std::max(distance(low, grey), distance(high, grey)); off > 1e-9)
            tell("reflection", Action::approximated,
                 fmt::format("{}, the mean over channels and a ball's picture", printNumber(grey)), off);
        if (f.reflectionExponent != 1)
            tell("reflection_exponent", Action::dropped,
                 fmt::format("{} becomes 1", printNumber(f.reflectionExponent)));
        surface_.material.reflection += grey;
        return grey;
    }

    void reportOmitted(const Texture& texture) {
        if (!texture.kind.empty())
            tell("texture", Action::approximated, texture.kind + ": one texture stands for it");
        if (!texture.pigment.pattern.empty())
            tell("pigment", Action::approximated, texture.pigment.pattern + ": its mean colour");
        if (texture.hasNormal) tell("normal", Action::dropped, "the surface is smooth");
        for (const std::string& word : texture.finish.ignored)
            tell(word, Action::dropped, "has no counterpart");
    }

    /// Each layer's terms are times the filters above it, which is how POV-Ray adds them.
    void reduceLayers() { tell("layers", Action::exact, "their sum, each seen through the ones above it"); }

    void finish() {
        Material& m = surface_.material;
        m.specular = highlights_.sum();
        m.exponent = highlights_.exponent();
        if (highlights_.isMixed())
            tell("highlights", Action::approximated,
                 fmt::format("several of different width have the exponent of the strongest, {}",
                             printNumber(m.exponent)));
        finishTransmission();
        if (isDark_)
            tell("transparency", Action::approximated, "filter + transmit exceed 1: POV-Ray darkens by that");
        if (m.transmission > 0) finishIndex();
        limit("ambient", m.ambient), limit("diffuse", m.diffuse), limit("specular", m.specular);
        if (m.reflection < 0) m.reflection = 0, tell("reflection", Action::dropped, "it is negative");
        if (m.exponent < 0) m.exponent = 0, tell("phong_size", Action::approximated, "it is negative: 0");
    }

    /// All of what passes is said by the tint: POV-Ray does not dim what is reflected totally, and with ct =
    /// 1 YARTE does not either.
    void finishTransmission() {
        limit("transmission", filter_);
        if (isBlack(filter_)) return;
        surface_.material.transmission = 1;
        surface_.material.tint = filter_;
    }

    void finishIndex() {
        Material& m = surface_.material;
        m.index = index_;
        if (!(m.index > 0)) m.index = 1, tell("ior", Action::approximated, "not positive: 1");
        if (m.index != 1 && m.reflection > 0)
            tell("total internal reflection", Action::approximated,
                 "the reflection of the finish is added to it; in POV-Ray it takes its place", m.reflection);
        if (m.index == 1)
            tell("levels", Action::approximated,
                 "a ray that passes unbent counts as one more; not in POV-Ray");
    }

    void limit(const char* property, Colour& c) {
        if (least(c) >= 0 || std::isnan(least(c))) return;
        tell(property, Action::approximated, "negative channels become 0", -least(c));
        c = {std::max(c.r, 0.0), std::max(c.g, 0.0), std::max(c.b, 0.0)};
    }

    const Interior* interior_;
    const TextureRules& rules_;
    double index_ = 1;
    Colour filter_{1, 1, 1}; ///< of all layers so far
    Highlights highlights_;
    bool isDark_ = false;
    Surface surface_;
};

} // namespace

Surface reduce(const Layers& layers, const Interior* interior, const TextureRules& rules) {
    return Reduction(interior, rules).reduce(layers);
}

} // namespace yarte::convert::povray::sdl
