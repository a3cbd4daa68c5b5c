#include "convert/gltf/read.h"

#include "convert/framing.h"
#include "convert/gltf/ordered.h"
#include "convert/gltf/read_body.h"
#include "convert/gltf/read_camera.h"
#include "convert/gltf/read_ledger.h"
#include "convert/gltf/read_light.h"
#include "yarte/scene/check.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <set>

namespace yarte::convert::gltf {
namespace {

// What viewers show and glTF does not say.
constexpr Colour viewerBackground{0.2, 0.2, 0.2}; ///< also what metals mirror
constexpr double displayGamma = 2.2;
constexpr int levelsThroughGlass = 6; ///< a glass in front of a mirror

class SceneReader {
public:
    SceneReader(Asset& asset, Ledger& ledger) : asset_(asset), ledger_(ledger), materials_(asset, ledger) {}

    std::optional<Scene> read() {
        readSettings();
        auto bodies = readBodies(asset_, materials_, exact_.value.meshes, ledger_);
        if (!bodies) return std::nullopt;
        scene_.bodies = std::move(bodies->bodies);
        scene_.meshes = std::move(bodies->meshes);
        takeMaterials();
        scene_.lights = readLights(asset_, bodies->extent, ledger_);
        const auto camera = readCamera(asset_, bodies->extent, ledger_);
        if (asset_.errors().any()) return std::nullopt;
        if (camera) scene_.camera = camera->camera;
        if (camera && !hasSettings()) scene_.resolution = camera->resolution;
        addWhatIsMissing({bodies->extent.centre(), bodies->extent.radius()}, camera.has_value());
        if (asset_.errors().any()) return std::nullopt;
        addSettings();
        tellWhatIsNotShown();
        addRows(asset_.root(), ledger_);
        return std::move(scene_);
    }

private:
    bool hasSettings() const { return exact_.state == Stored::valid; }

    /// From the extras of the scene that is taken.
    void readSettings() {
        const Json* scenes = asset_.root().find("scenes");
        const auto taken = asset_.document().scene;
        if (!scenes || !taken) return;
        exact_ = exactScene(scenes->items()[*taken].find("extras"));
        if (!exact_.why.empty())
            ledger_.add({fmt::format("/scenes/{}", *taken),
                         "exact settings in extras",
                         Action::dropped,
                         exact_.why,
                         {}});
        if (!hasSettings()) return;
        const Scene& settings = exact_.value.settings;
        scene_.resolution = settings.resolution;
        scene_.background = settings.background;
        scene_.maxRecursion = settings.maxRecursion;
        scene_.gamma = settings.gamma;
    }

    void addWhatIsMissing(const Ball& ball, bool hasCamera) {
        Problems problems;
        if (!hasCamera) {
            addCamera(scene_, ball, ledger_);
            problems = check(scene_.camera);
        }
        if (scene_.lights.empty() && !(hasSettings() && exact_.value.lightCount == 0)) {
            addLight(scene_, ball, ledger_);
            std::ranges::move(check(scene_.lights.back()), std::back_inserter(problems));
        }
        if (!problems.empty()) // numbers near their limits leave no room for a place that sees all
            asset_.errors().report("gltf.too-large",
                                   "no camera and light can be added to a scene of this size: " +
                                       problems[0].message,
                                   asset_.root());
    }

    void addSettings() {
        if (hasSettings()) return;
        scene_.gamma = displayGamma;
        scene_.background = viewerBackground;
        const bool hasRays = std::ranges::any_of(
            scene_.materials, [](const Material& m) { return m.reflection > 0 || transmits(m); });
        if (hasRays) scene_.maxRecursion = levelsThroughGlass;
        ledger_.add({"scene", "gamma, background, recursion", Action::added, "as viewers show it", {}});
    }

    /// In the order that they had when they were written, with those that no body uses in their places.
    void takeMaterials() {
        constexpr std::uint32_t unused = 0xffffffff;
        struct Slot {
            Material material;
            std::uint32_t index = unused; ///< in materials_.all()
        };
        std::vector<Ordered<Slot>> slots;
        for (std::uint32_t i = 0; i < materials_.all().size(); ++i)
            slots.push_back({materials_.all()[i].order, {materials_.all()[i].material, i}});
        for (const UnusedMaterial& material : exact_.value.unusedMaterials)
            slots.push_back({material.order, {material.material}});
        std::vector<std::uint32_t> newIndex(materials_.all().size());
        for (const Slot& slot : sorted(std::move(slots))) {
            if (slot.index != unused)
                newIndex[slot.index] = static_cast<std::uint32_t>(scene_.materials.size());
            scene_.materials.push_back(slot.material);
        }
        for (Body& body : scene_.bodies) body.material.index = newIndex[body.material.index];
    }

    void tellWhatIsNotShown() {
        const Document& document = asset_.document();
        const Json* scenes = asset_.root().find("scenes");
        for (std::size_t i = 0; scenes && i < scenes->items().size(); ++i)
            if (i != document.scene)
                ledger_.add({fmt::format("/scenes/{}", i),
                             "scene",
                             Action::dropped,
                             fmt::format("/scenes/{} is taken", *document.scene),
                             {}});
        const Hierarchy& hierarchy = asset_.hierarchy();
        const auto tell = [&](const char* where, const char* property, std::size_t count,
                              const char* detail) {
            if (count > 0)
                ledger_.add({where, property, Action::dropped, fmt::format("{} {}", count, detail), {}});
        };
        tell("/nodes", "not in the scene", document.nodes.size() - hierarchy.inScene().size(), "of them");
        tell("/nodes", "not visible", hierarchy.inScene().size() - hierarchy.shown().size(), "of them");
        std::set<std::uint32_t> meshes;
        for (const std::uint32_t node : hierarchy.shown())
            if (document.nodes[node].mesh) meshes.insert(*document.nodes[node].mesh);
        tell("/meshes", "not shown by any node", document.meshes.size() - meshes.size(), "of them");
    }

    Asset& asset_;
    Ledger& ledger_;
    Materials materials_;
    Exact<ExactScene> exact_;
    Scene scene_;
};

} // namespace

std::optional<Scene> readScene(Conversion& c) {
    const Source& source = c.sources[c.input.text];
    const auto asset =
        Asset::open(source.text(), source.name(), uriBase(c.input.file, c.input.readable), c.diagnostics);
    if (!asset) return std::nullopt;
    return SceneReader(*asset, c.ledger).read();
}

} // namespace yarte::convert::gltf
