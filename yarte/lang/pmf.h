// .pmf: polygonal mesh files (the paper, section 1; SCENE-LANGUAGE decision D8; optional vertex normals are
// our extension).
#pragma once

#include "yarte/base/diagnostic.h"
#include "yarte/base/file.h"
#include "yarte/base/source.h"
#include "yarte/scene/mesh_data.h"

#include <filesystem>
#include <optional>
#include <string>

namespace yarte {

/// The mesh in a text, or nothing after reporting why. `path` is left empty.
std::optional<MeshData> parsePmf(SourceId text, const Sources&, Diagnostics&);

/// A mesh file; fits MeshFormat::read. A missing or unreadable file is a diagnostic.
std::optional<MeshData> readPmf(const std::filesystem::path& file, const ReadableFolders&, Sources&,
                                Diagnostics&);

/// Text that parsePmf reads back to the same mesh, bit for bit.
std::string printPmf(const MeshData&);

} // namespace yarte
