#include "validate/baseline.h"

#include "validate/case_names.h"
#include "validate/compare.h"
#include "validate/image_file.h"
#include "validate/report_text.h"
#include "validate/text.h"
#include "yarte/base/file.h"
#include "yarte/base/image_file.h"
#include "yarte/base/image_layers.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <map>
#include <nlohmann/json.hpp>

namespace yarte::validate {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

fs::path indexFile(const fs::path& folder) { return folder / "baseline.json"; }

std::vector<Baseline::Scene> readIndex(const fs::path& folder) {
    std::vector<Baseline::Scene> scenes;
    if (!fs::exists(indexFile(folder))) return scenes;
    try {
        const Json index = Json::parse(readFile(indexFile(folder)));
        for (const Json& entry : index.at("references")) {
            scenes.push_back({entry.at("name"), entry.at("scene").get<std::string>()});
            if (scenes.back().name != folderName(scenes.back().name)) // it becomes the name of a file
                throw FileError(indexFile(folder),
                                "not the name of a case: " + cleanText(scenes.back().name));
        }
    } catch (const Json::exception& error) {
        throw FileError(indexFile(folder), error.what());
    }
    return scenes;
}

std::string changeText(const BaselineChange& change) {
    return change.maxAbs ? fmt::format("max {}", errorText(*change.maxAbs)) : "another size";
}

} // namespace

Baseline::Baseline(fs::path folder) : folder_(std::move(folder)), scenes_(readIndex(folder_)) {}

bool Baseline::has(const std::string& name) const { return fs::exists(pictureFile(name)); }

Picture Baseline::read(const std::string& name) const {
    if (!has(name))
        throw CaseError(
            fmt::format("no reference in {}: make it with --update-baseline", cleanText(folder_.string())));
    try {
        return readPicture(pictureFile(name));
    } catch (const ImageError& error) {
        throw CaseError(cleanText(error.what()));
    }
}

void Baseline::store(const std::string& name, const Picture& picture) const {
    fs::create_directories(folder_);
    writeFile(pictureFile(name), encodeExr(picture.view(), {}));
}

std::optional<Layers> Baseline::readBodies(const std::string& name) const {
    if (!fs::exists(bodiesFile(name))) return std::nullopt;
    try {
        return readLayers(bodiesFile(name));
    } catch (const ImageError&) { // a cause that cannot be found is no reason to compare nothing
        return std::nullopt;
    }
}

void Baseline::storeBodies(const std::string& name, const std::optional<Layers>& layers) const {
    if (!layers) {
        fs::remove(bodiesFile(name));
        return;
    }
    LayeredImage image{layers->width, layers->height, {}, {{"yarte.scene", layers->scene}}};
    for (const auto& [channel, values] : layers->channels) image.layers.push_back({channel, values});
    fs::create_directories(folder_);
    writeFile(bodiesFile(name), encodeExrLayers(image));
}

std::vector<std::string> Baseline::update(const std::vector<Scene>& stored) {
    std::map<std::string, fs::path> scenes;
    for (const Scene& scene : scenes_) scenes[scene.name] = scene.file;
    for (const Scene& scene : stored)
        scenes[scene.name] = fs::absolute(scene.file)
                                 .lexically_normal()
                                 .lexically_relative(fs::absolute(folder_).lexically_normal());
    std::vector<std::string> removed;
    std::erase_if(scenes, [&](const auto& scene) {
        if (fs::exists(folder_ / scene.second)) return false;
        fs::remove(pictureFile(scene.first));
        fs::remove(bodiesFile(scene.first));
        removed.push_back(scene.first);
        return true;
    });
    Json json = {{"schema", 1}, {"references", Json::array()}};
    scenes_.clear();
    for (const auto& [name, file] : scenes) {
        scenes_.push_back({name, file});
        json["references"].push_back({{"name", name}, {"scene", cleanText(file.generic_string())}});
    }
    fs::create_directories(folder_);
    writeFile(indexFile(folder_), json.dump(2) + "\n");
    return removed;
}

std::string baselineLine(const Report& report, const std::vector<std::string>& removed) {
    std::vector<std::string> added, changed;
    std::size_t unchanged = 0;
    for (const CaseReport& c : report.cases) {
        if (!c.baselineChange) continue;
        switch (c.baselineChange->kind) {
        case BaselineChange::Kind::added: added.push_back(c.name); break;
        case BaselineChange::Kind::changed:
            changed.push_back(fmt::format("{}: {}", c.name, changeText(*c.baselineChange)));
            break;
        case BaselineChange::Kind::unchanged: ++unchanged; break;
        }
    }
    const auto part = [](const char* what, const std::vector<std::string>& names) {
        return names.empty() ? fmt::format("0 {}", what)
                             : fmt::format("{} {} ({})", names.size(), what, fmt::join(names, ", "));
    };
    return fmt::format("baseline: {}, {}, {}, {} unchanged", part("new", added), part("changed", changed),
                       part("removed", removed), unchanged);
}

} // namespace yarte::validate
