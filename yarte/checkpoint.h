// What a checkpoint is bound to.
#pragma once

#include "yarte/base/source.h"
#include "yarte/engine/journal.h"
#include "yarte/options.h"
#include "yarte/scene/scene.h"

#include <vector>

namespace yarte {

/// All that a tile's bytes depend on: the program's version, the scene's text, the content of its meshes, and
/// the options that matter. Not among them: how many work, and what is written in the end.
std::vector<JournalItem> checkpointItems(const Options&, const Source& sceneText, const Scene&, Resolution,
                                         Tile region);

} // namespace yarte
