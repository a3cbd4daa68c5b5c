#include "convert/povray/appearance.h"

#include "convert/povray/sdl_text.h"
#include "yarte/base/number.h"

#include <fmt/format.h>

#include <algorithm>

namespace yarte::convert::povray {
namespace {

std::string colours(Colour ambient, Colour diffuse, Colour specular) {
    return fmt::format("{}, {}, {}", sdl(ambient), sdl(diffuse), sdl(specular));
}

std::string front(const Material& m) { return colours(m.ambient, m.diffuse, m.specular); }

bool isTinted(const Material& m) { return m.tint != Material{}.tint; }

std::string numbers(const Material& m) {
    const std::string four = fmt::format("{}, {}, {}, {}", printNumber(m.exponent), printNumber(m.reflection),
                                         printNumber(m.transmission), printNumber(m.index));
    return isTinted(m) ? fmt::format("{}, {}", four, sdl(m.tint)) : four;
}

/// The macro's name.
std::string macro(const Material& m, const char* kind) {
    return fmt::format("Yarte_{}{}", isTinted(m) ? "Tinted_" : "", kind);
}

double least(Colour c) { return std::min({c.r, c.g, c.b}); }

/// One texture of POV-Ray scales its local terms by 1 - Ct, gives a mirror ray of total reflection its full
/// weight, and has grey highlights and one pigment for both A and D.
void reportPlain(const std::string& where, const Material& m, const BackColours& c, Ledger& ledger) {
    const auto row = [&](const char* property, Action action, const char* detail,
                         std::optional<double> bound) {
        ledger.add({where, property, action, detail, bound});
    };
    if (least(c.specular) != maxComponent(c.specular))
        row("specular", Action::approximated, "grey, the largest channel",
            maxComponent(c.specular) - least(c.specular));
    const auto isStoodIn = [](double a, double d) { return a > 0 && d < 1e-6; };
    if (isStoodIn(c.ambient.r, c.diffuse.r) || isStoodIn(c.ambient.g, c.diffuse.g) ||
        isStoodIn(c.ambient.b, c.diffuse.b))
        row("diffuse", Action::approximated, "1e-6 where it is 0 and the ambient is not", 1e-6);
    if (transmits(m) && (m.transmission != 1 || m.reflection > 0))
        row("transmission", Action::approximated, "total internal reflection has weight 1", {});
    if (m.transmission >= 1 && !(isBlack(c.ambient) && isBlack(c.diffuse)))
        row("ambient and diffuse", Action::dropped, "POV-Ray scales them by 1 - transmission", {});
}

} // namespace

Appearances::Appearances(const Scene& scene) : names_(scene.bodies.size()) {
    std::vector<std::vector<std::size_t>> bodiesOf(scene.materials.size());
    for (std::size_t i = 0; i < scene.bodies.size(); ++i)
        bodiesOf[scene.bodies[i].material.index].push_back(i);
    for (std::size_t id = 0; id < scene.materials.size(); ++id) {
        const Material& m = scene.materials[id];
        const std::string name = fmt::format("Material_{}", id + 1);
        declarations_ +=
            fmt::format("#declare {} = {}({}, {})\n", name, macro(m, "Material"), front(m), numbers(m));
        // Its two-sided forms follow at once: with their first arguments they tell which material they are
        // of.
        std::vector<const BackColours*> known;
        for (const std::size_t i : bodiesOf[id]) {
            const std::optional<BackColours>& back = scene.bodies[i].back;
            if (!back) {
                names_[i] = name;
                continue;
            }
            const auto found = std::ranges::find_if(known, [&](const BackColours* b) { return *b == *back; });
            names_[i] = fmt::format("{}_Back_{}", name, found - known.begin() + 1);
            if (found != known.end()) continue;
            known.push_back(&*back);
            declarations_ +=
                fmt::format("#declare {} = {}({}, {}, {})\n", names_[i], macro(m, "Two_Sided"), front(m),
                            colours(back->ambient, back->diffuse, back->specular), numbers(m));
        }
    }
}

void reportMaterials(const Scene& scene, bool plain, Ledger& ledger) {
    for (std::size_t i = 0; i < scene.materials.size(); ++i) {
        const std::string where = fmt::format("material {}", i + 1);
        const Material& m = scene.materials[i];
        if (plain)
            reportPlain(where, m, {m.ambient, m.diffuse, m.specular}, ledger);
        else
            ledger.add({where, "everything", Action::exact, "POV-Ray computes with it in float32", {}});
    }
    for (std::size_t i = 0; plain && i < scene.bodies.size(); ++i)
        if (const Body& body = scene.bodies[i]; body.back)
            reportPlain(fmt::format("body {}, back", i + 1), scene.materials[body.material.index], *body.back,
                        ledger);
}

} // namespace yarte::convert::povray
