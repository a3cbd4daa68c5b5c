// The picture that --aov writes: every channel of every pixel, and what the scene's file says of its bodies
// and lights. The format is in README.md, "--aov FILE".
#pragma once

#include "yarte/base/image_layers.h"
#include "yarte/base/source.h"
#include "yarte/engine/render.h"
#include "yarte/scene/scene.h"

#include <optional>

namespace yarte {

/// Of the region that `options` name; nothing if `progress` stopped it. Worker processes become threads: the
/// channels are not in shared memory. Throws as render().
std::optional<LayeredImage> aovImage(const Scene&, const Sources&, const World&, RenderOptions options,
                                     const ProgressFunction& progress);

} // namespace yarte
