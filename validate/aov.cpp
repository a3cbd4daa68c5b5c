#include "validate/aov.h"

#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <utility>

namespace yarte::validate {

namespace {

class Reader {
public:
    explicit Reader(const Layers& layers) : layers_(layers) {}

    bool has(const std::string& name) const { return layers_.channels.contains(name); }
    const std::vector<float>& floats(const std::string& name) const {
        const auto found = layers_.channels.find(name);
        if (found == layers_.channels.end()) throw ImageError(fmt::format("no channel {}", name));
        return found->second;
    }
    std::vector<int> integers(const std::string& name) const {
        const std::vector<float>& values = floats(name);
        std::vector<int> result(values.size());
        std::transform(values.begin(), values.end(), result.begin(),
                       [](float v) { return static_cast<int>(v); });
        return result;
    }
    std::vector<Colour> colours(const std::string& name) const {
        const auto &r = floats(name + ".R"), &g = floats(name + ".G"), &b = floats(name + ".B");
        std::vector<Colour> result(r.size());
        for (std::size_t i = 0; i < r.size(); ++i) result[i] = {r[i], g[i], b[i]};
        return result;
    }
    /// "shadow.lights", "shadow.lights1", ...
    AovMask mask(const std::string& name) const {
        std::vector<std::vector<std::uint32_t>> words;
        for (std::string channel = name; has(channel); channel = fmt::format("{}{}", name, words.size())) {
            const std::vector<float>& values = floats(channel);
            words.emplace_back(values.begin(), values.end());
        }
        return AovMask(std::move(words));
    }

private:
    const Layers& layers_;
};

std::vector<std::vector<AovVisit>> readVisits(const Reader& reader, std::size_t size) {
    std::vector<std::vector<AovVisit>> visits(size);
    for (int n = 0; reader.has(fmt::format("visit{}.body", n)); ++n) {
        const std::string name = fmt::format("visit{}", n);
        const std::vector<int> body = reader.integers(name + ".body");
        const auto& back = reader.floats(name + ".back");
        const auto weight = reader.colours(name + ".weight"), lit = reader.colours(name + ".lit"),
                   highlight = reader.colours(name + ".highlight"),
                   reflected = reader.colours(name + ".reflected"),
                   transmitted = reader.colours(name + ".transmitted");
        for (std::size_t i = 0; i < size; ++i)
            if (body[i] >= 0)
                visits[i].push_back(
                    {body[i], back[i] != 0, weight[i], lit[i], highlight[i], reflected[i], transmitted[i]});
    }
    return visits;
}

void readScene(const std::string& text, const Reader& reader, Aov& aov) {
    const auto json = nlohmann::json::parse(text);
    for (const auto& body : json.at("bodies")) {
        const auto& t = body.at("transmission");
        aov.bodies.push_back({body.at("kind"),
                              body.at("line"),
                              body.at("exponent"),
                              body.at("reflection"),
                              {t[0], t[1], t[2]}});
    }
    for (const auto& light : json.at("lights")) {
        const auto& b = light.at("brightness");
        const std::string name = fmt::format("light{}", aov.lights.size());
        if (!reader.has(name + ".arriving.R")) break; // more lights than have channels
        aov.lights.push_back({light.at("line"),
                              reader.colours(name + ".arriving"),
                              reader.floats(name + ".mirror"),
                              reader.colours(name),
                              {b[0], b[1], b[2]}});
    }
}

} // namespace

std::string AovBody::name() const {
    std::string words = kind;
    std::replace(words.begin(), words.end(), '_', ' ');
    return fmt::format("{} at line {}", words, line);
}

std::string AovLight::name() const { return fmt::format("light at line {}", line); }

Aov aovFrom(const Layers& layers) {
    const Reader reader(layers);
    Aov aov;
    aov.width = layers.width;
    aov.height = layers.height;
    try {
        readScene(layers.scene, reader, aov);
    } catch (const nlohmann::json::exception& error) {
        throw ImageError(fmt::format("the attribute yarte.scene: {}", error.what()));
    }
    aov.body = reader.integers("body.id");
    aov.reflectedBody = reader.integers("reflected.id");
    aov.transmittedBody = reader.integers("transmitted.id");
    aov.depth = reader.floats("depth.Z");
    aov.backgroundWeight = reader.colours("background.weight");
    aov.visits = readVisits(reader, aov.size());
    aov.shadowedLights = reader.mask("shadow.lights");
    aov.secondaryBodies = reader.mask("secondary.bodies");
    aov.castingBodies = reader.mask("casting.bodies");
    const auto known = [&](int body) { return body >= -1 && body < static_cast<int>(aov.bodies.size()); };
    for (const auto* ids : {&aov.body, &aov.reflectedBody, &aov.transmittedBody})
        if (!std::all_of(ids->begin(), ids->end(), known))
            throw ImageError("a body id that is not in yarte.scene");
    return aov;
}

} // namespace yarte::validate
