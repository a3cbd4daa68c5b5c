#include "yarte/lang/mesh_files.h"

#include "yarte/base/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace yarte {
namespace fs = std::filesystem;

MeshFiles::MeshFiles(fs::path folder, const SceneReading& reading, Sources& sources, Diagnostics& diagnostics)
    : folder_(std::move(folder)), readable_(reading.readable), formats_(reading.meshes),
      inMemory_(reading.inMemory), sources_(sources), diagnostics_(diagnostics) {
    readable_.folders.push_back(folder_);
}

const MeshFormat* MeshFiles::formatOf(const fs::path& file, Span span) {
    std::string extension = file.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    std::string known;
    for (const MeshFormat& format : formats_) {
        if (format.extension == extension) return &format;
        known += fmt::format("{}{}", known.empty() ? "" : " or ", format.extension);
    }
    diagnostics_.error("scene.unknown-mesh-format",
                       fmt::format("a mesh file's name must end in {}, got {}", known, inQuotes(extension)),
                       span);
    return nullptr;
}

std::optional<MeshId> MeshFiles::findInMemory(const std::string& name, std::vector<MeshData>& meshes) {
    const auto given = std::ranges::find(inMemory_, name, &MeshData::path);
    if (given == inMemory_.end()) return std::nullopt;
    const auto there = std::ranges::find(meshes, name, &MeshData::path);
    const MeshId id{static_cast<std::uint32_t>(there - meshes.begin())};
    if (there == meshes.end()) meshes.push_back(*given);
    return id;
}

std::optional<MeshId> MeshFiles::find(const std::string& name, Span span, std::vector<MeshData>& meshes) {
    if (const auto id = findInMemory(name, meshes)) return id;
    const fs::path file = (folder_ / name).lexically_normal();
    if (!readable_.contain(file)) {
        diagnostics_.error(
            "scene.path-not-allowed",
            fmt::format("{} must lie in the scene's folder or one that is allowed", inQuotes(name)), span);
        return std::nullopt;
    }
    if (const auto reason = whyUnreadable(file)) {
        diagnostics_.error("scene.mesh-unreadable",
                           fmt::format("cannot read {}: {}", inQuotes(name), *reason), span);
        return std::nullopt;
    }
    std::error_code error;
    const auto [entry, isNew] = known_.try_emplace(fs::canonical(file, error));
    if (!isNew) return entry->second;
    const MeshFormat* format = formatOf(file, span);
    if (format == nullptr) return std::nullopt;
    std::optional<MeshData> mesh = format->read(file, readable_, sources_, diagnostics_);
    if (!mesh) return std::nullopt;
    mesh->path = name;
    entry->second = MeshId{static_cast<std::uint32_t>(meshes.size())};
    meshes.push_back(std::move(*mesh));
    return entry->second;
}

} // namespace yarte
