// Reading a scene: text to Scene, with every error of the file in one run. The grammar is in
// yarte/LANGUAGE.md.
#pragma once

#include "yarte/base/diagnostic.h"
#include "yarte/base/file.h"
#include "yarte/base/source.h"
#include "yarte/scene/scene.h"

#include <filesystem>
#include <optional>
#include <span>
#include <string_view>

namespace yarte {

/// A format that the `mesh` directive can read. main passes the table, so that this library knows none but
/// .pmf.
struct MeshFormat {
    std::string_view extension; ///< with the dot, lower case
    /// The content of `file`, or nothing after reporting why. `file` is already known to be readable by the
    /// scene.
    std::optional<MeshData> (*read)(const std::filesystem::path& file, const ReadableFolders&, Sources&,
                                    Diagnostics&);
};

/// What a scene may refer to.
struct SceneReading {
    ReadableFolders readable;             ///< besides the scene's own folder
    std::span<const MeshFormat> meshes;   ///< formats of the `mesh` directive
    std::span<const MeshData> inMemory{}; ///< found by their path before any file is looked for
};

/// Reads and checks a scene file. Nothing is returned if there was an error (warnings are in `diagnostics`
/// all the same). Throws FileError if the scene file itself cannot be read; a mesh that cannot be read is a
/// diagnostic.
std::optional<Scene> readScene(const std::filesystem::path& file, const SceneReading&, Sources&,
                               Diagnostics&);

/// The same for a text; `folder` is where its mesh paths start.
std::optional<Scene> parseScene(SourceId text, const std::filesystem::path& folder, const SceneReading&,
                                Sources&, Diagnostics&);

} // namespace yarte
