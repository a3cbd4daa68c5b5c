#include "convert/gltf/read_light.h"

#include "convert/gltf/exact.h"
#include "convert/gltf/light_map.h"
#include "convert/gltf/ordered.h"
#include "yarte/base/number.h"
#include "yarte/scene/check.h"

#include <fmt/format.h>

#include <algorithm>

namespace yarte::convert::gltf {
namespace {

/// Sums of brightness that need no other exposure: a display shows up to 1.
constexpr double darkest = 0.05, brightest = 4;
/// A directional light stands so many radii of the scene away: within it, its rays part by less than half the
/// inverse, as an angle.
constexpr double farAway = 100;

/// A light as KHR_lights_punctual describes it.
struct Punctual {
    std::string type;
    Colour colour{1, 1, 1};
    double intensity = 1;
};

Punctual readPunctual(const Object& object) {
    object.require("type");
    Punctual light{object.text("type", "point"), object.colour("color", {1, 1, 1}, notNegative),
                   object.number("intensity", 1, notNegative)};
    if (light.type != "point" && light.type != "spot" && light.type != "directional")
        object.error("gltf.out-of-range", "must be point, spot or directional", "type");
    return light;
}

class LightReader {
public:
    LightReader(Asset& asset, const Extent& extent, Ledger& ledger)
        : asset_(asset), extent_(extent), ledger_(ledger) {
        const Object root(asset.root(), asset.errors());
        if (const auto extension = root.extension("KHR_lights_punctual");
            extension && extension->has("lights"))
            definitions_ = extension->objects("lights");
    }

    std::vector<Light> read() {
        for (const std::uint32_t node : asset_.hierarchy().shown()) readNode(node);
        expose();
        return sorted(std::move(lights_));
    }

private:
    void readNode(std::uint32_t id) {
        const Node& node = asset_.document().nodes[id];
        const Json* extras = node.json->find("extras");
        const Transform& world = asset_.hierarchy().world(id);
        if (!node.light && (!extras || !definitions_.empty())) return;
        std::optional<Punctual> punctual;
        if (node.light) punctual = readPunctual(definitions_[*node.light]);
        std::optional<ShownLight> shown;
        if (punctual && punctual->type == "point") shown = {punctual->colour, punctual->intensity};
        const bool canBeExact = shown || !punctual;
        Exact<Light> exact;
        if (canBeExact) exact = exactLight(extras, world.translation, shown);
        if (exact.state == Stored::valid) {
            hasExact_ = true;
            lights_.push_back({exact.order, exact.value});
            return;
        }
        const std::string where = fmt::format("/nodes/{}", id);
        if (!exact.why.empty()) ledger_.add({where, "exact light in extras", Action::dropped, exact.why, {}});
        if (!punctual) return;
        lights_.push_back({exact.order, approximate(*punctual, world, where)});
        definitions_[*node.light].json().change(Fate::read, Fate::approximated);
        if (const Problems problems = check(lights_.back().value); !problems.empty())
            asset_.errors().report(problems[0].code, problems[0].message, *node.json);
    }

    Light approximate(const Punctual& light, const Transform& world, const std::string& where) {
        const auto tell = [&](std::string detail) {
            ledger_.add({where, light.type + " light", Action::approximated, std::move(detail), {}});
        };
        if (light.type == "directional") {
            const double distance = farAway * extent_.radius();
            tell(fmt::format("a point light at a distance of {} from the scene's centre",
                             printNumber(distance)));
            const Vec3 towards = world.z == Vec3{} ? Vec3{0, 0, 1} : normalised(world.z);
            return {
                extent_.centre() + towards * distance, light.colour * brightnessOfLux(light.intensity), {}};
        }
        // Near the centre a point light would outshine all: no nearer than half the scene's radius counts.
        const double distance = std::max(length(world.translation - extent_.centre()), extent_.radius() / 2);
        tell(fmt::format("as bright everywhere as at a distance of {}{}", printNumber(distance),
                         light.type == "spot" ? ", and in all directions as along its axis" : ""));
        return {world.translation, light.colour * brightnessOfCandela(light.intensity, distance), {}};
    }

    /// Lights are in physical units: a street lamp and the sun each need an exposure of their own.
    void expose() {
        double sum = 0;
        for (const auto& light : lights_) sum += maxComponent(light.value.brightness);
        if (hasExact_ || sum == 0 || (sum >= darkest && sum <= brightest)) return;
        for (auto& light : lights_) {
            Colour& b = light.value.brightness;
            b = {b.r / sum, b.g / sum, b.b / sum}; // 1 / sum could be infinite
        }
        ledger_.add({"lights",
                     "exposure",
                     Action::approximated,
                     fmt::format("all lights are divided by {}, so that they sum to 1", printNumber(sum)),
                     {}});
    }

    Asset& asset_;
    const Extent& extent_;
    Ledger& ledger_;
    std::vector<Object> definitions_;
    std::vector<Ordered<Light>> lights_;
    bool hasExact_ = false;
};

} // namespace

std::vector<Light> readLights(Asset& asset, const Extent& extent, Ledger& ledger) {
    return LightReader(asset, extent, ledger).read();
}

} // namespace yarte::convert::gltf
