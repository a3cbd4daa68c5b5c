// KHR_lights_punctual as point lights without fall-off.
#pragma once

#include "convert/gltf/asset.h"
#include "convert/gltf/extent.h"
#include "convert/ledger.h"
#include "yarte/scene/scene.h"

namespace yarte::convert::gltf {

/// The lights of the shown nodes, in the order that extras give them. Each is as bright everywhere as it was
/// at the centre of `extent`; all together are made brighter or darker if no display could show them.
std::vector<Light> readLights(Asset&, const Extent& extent, Ledger&);

} // namespace yarte::convert::gltf
