// What a glTF material says, textures averaged in.
#pragma once

#include "convert/gltf/material_map.h"
#include "convert/gltf/textures.h"

namespace yarte::convert::gltf {

/// Average of a primitive's vertex colours: a factor of the base colour.
struct Tint {
    Colour colour{1, 1, 1};
    double alpha = 1;
    friend bool operator==(const Tint&, const Tint&) = default;
};

PbrMaterial readPbr(const Object& material, const Tint&, Textures&);

} // namespace yarte::convert::gltf
