// MeshFiles: the mesh files that a scene names, each read once.
#pragma once

#include "yarte/lang/scene_reader.h"

#include <map>

namespace yarte {

class MeshFiles {
public:
    MeshFiles(std::filesystem::path folder, const SceneReading&, Sources&, Diagnostics&);

    /// The id in `meshes` of the file that the scene calls `name`, read if it is new; nothing after reporting
    /// why at `span`, or before when the file itself was found bad.
    std::optional<MeshId> find(const std::string& name, Span span, std::vector<MeshData>& meshes);

private:
    std::optional<MeshId> findInMemory(const std::string& name, std::vector<MeshData>& meshes);
    const MeshFormat* formatOf(const std::filesystem::path& file, Span span);

    std::filesystem::path folder_;
    ReadableFolders readable_;
    std::span<const MeshFormat> formats_;
    std::span<const MeshData> inMemory_;
    Sources& sources_;
    Diagnostics& diagnostics_;
    std::map<std::filesystem::path, std::optional<MeshId>> known_; ///< by the path with links resolved
};

} // namespace yarte
