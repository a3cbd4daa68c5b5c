#include "validate/removal.h"

#include "validate/attribution.h"

#include <array>
#include <cstddef>
#include <fmt/format.h>
#include <string_view>

namespace yarte::validate {

namespace {

/// Lines move when something is taken out; the rest does not.
bool isSame(const AovBody& a, const AovBody& b) {
    return a.kind == b.kind && a.exponent == b.exponent && a.reflection == b.reflection &&
           a.transmission == b.transmission;
}

/// Whether the bodies `now` are some of `before`, in their order, and can be so without the one that is
/// `gone`.
bool canBeWithout(const std::vector<AovBody>& before, std::size_t gone, const std::vector<AovBody>& now) {
    std::size_t found = 0;
    for (std::size_t i = 0; i < before.size() && found < now.size(); ++i)
        if (i != gone && isSame(before[i], now[found])) ++found;
    return found == now.size();
}

} // namespace

Layers bodiesOnly(const Layers& all) {
    constexpr std::array<std::string_view, 8> kept = {
        "body.id",           "reflected.id",  "transmitted.id",   "depth.Z",
        "background.weight", "shadow.lights", "secondary.bodies", "casting.bodies"};
    Layers layers{all.width, all.height, {}, all.scene};
    for (const auto& [name, values] : all.channels)
        for (const std::string_view prefix : kept) // masks of many bodies are numbered: casting.bodies1
            if (name.starts_with(prefix)) layers.channels[name] = values;
    return layers;
}

std::optional<Explanation> explainRemoval(const Difference& difference, const Aov& reference,
                                          const std::vector<AovBody>& now) {
    if (now.size() >= reference.bodies.size()) return std::nullopt;
    Explanation explanation = explain(difference, reference);
    if (!explanation.common || !explanation.common->body) return std::nullopt;
    const auto gone = static_cast<std::size_t>(*explanation.common->body);
    if (!canBeWithout(reference.bodies, gone, now)) return std::nullopt;

    const std::string before = explanation.common->explanation;
    const std::string subject = reference.bodies[gone].name() + " of the reference's scene";
    std::string text = fmt::format("the {} is gone", subject);
    if (const std::size_t count = reference.bodies.size() - now.size(); count > 1)
        text += fmt::format(", one of {} bodies", count);
    // It has no place in the new scene: neither a number nor a line.
    explanation.common = Finding{Cause::body, {}, {}, subject, 0, text};
    for (Region& region : explanation.regions) {
        const std::string role = region.finding.explanation.substr(before.size());
        region.finding = *explanation.common;
        region.finding.explanation += role;
    }
    return explanation;
}

} // namespace yarte::validate
