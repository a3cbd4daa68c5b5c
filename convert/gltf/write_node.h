// A node's place.
#pragma once

#include "convert/gltf/write_json.h"
#include "yarte/base/frame.h"

namespace yarte::convert::gltf {

/// As translation, rotation and scale, without those that change nothing.
void setTransform(Json& node, const Frame& axes, double scale, Vec3 translation);

} // namespace yarte::convert::gltf
