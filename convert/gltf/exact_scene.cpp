// What a scene's extras say: the part of exact.h that nothing visible can contradict.
#include "convert/gltf/exact.h"
#include "convert/gltf/exact_text.h"
#include "convert/gltf/percent.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace yarte::convert::gltf {
namespace {

std::string textOf(const Json& json, const char* name) {
    const Json* value = json.find(name);
    return value && value->text() ? *value->text() : "";
}

/// 0 where there is none.
std::size_t countOf(const Json& json, const char* name) {
    const Json* value = json.find(name);
    const bool isCount = value && value->number() && *value->number() >= 0 && *value->number() < 1e9;
    return isCount ? static_cast<std::size_t>(*value->number()) : 0;
}

bool readMaterials(const Json& list, std::vector<UnusedMaterial>& materials, std::string& why) {
    for (const Json& item : list.items()) {
        const std::optional<Scene> scene = sceneOf(textOf(item, "text"), why);
        if (!scene || scene->materials.size() != 1) return false;
        materials.push_back({countOf(item, "material"), scene->materials[0]});
    }
    return true;
}

bool readMeshes(const Json& list, std::vector<ExactMesh>& meshes, std::string& why) {
    for (const Json& item : list.items()) {
        ExactMesh& mesh = meshes.emplace_back();
        mesh.path = percentDecoded(textOf(item, "path"));
        const Json* pmf = item.find("pmf");
        if (pmf == nullptr) continue;
        mesh.data = meshOf(textOf(item, "pmf"), why);
        if (!mesh.data) return false;
        mesh.data->path = mesh.path;
    }
    return true;
}

} // namespace

Exact<ExactScene> exactScene(const Json* extras) {
    const Json* record = extras ? extras->find("yarte") : nullptr;
    if (record == nullptr || record->find("scene") == nullptr) return {};
    Exact<ExactScene> result{Stored::unreadable, {}, {}, {}};
    std::optional<Scene> settings = sceneOf(textOf(*record, "text"), result.why);
    const Json none;
    const auto list = [&](const char* name) -> const Json& {
        const Json* found = record->find(name);
        return found ? *found : none;
    };
    if (settings && readMaterials(list("unusedMaterials"), result.value.unusedMaterials, result.why) &&
        readMeshes(list("meshes"), result.value.meshes, result.why)) {
        result.value.settings = std::move(*settings);
        result.value.settings.materials.clear();
        result.value.lightCount = countOf(*record, "lights");
        result.state = Stored::valid;
    }
    record->markAll(Fate::inExtras);
    return result;
}

} // namespace yarte::convert::gltf
