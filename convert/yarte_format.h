// .yarte: YARTE's own scenes. Reading and printing are yarte_lang's; here is what becomes of the mesh files.
#pragma once

#include "convert/format.h"

namespace yarte::convert {

std::optional<Scene> readYarteScene(Conversion&);

/// The scene's text, and each of its meshes as `<stem>.<n>.pmf` beside it (n from 1). A mesh whose path leads
/// to the very same mesh from the output's place keeps its path; so do all with `options.canonical`.
std::vector<OutputFile> writeYarteScene(const Scene&, Conversion&);

} // namespace yarte::convert
