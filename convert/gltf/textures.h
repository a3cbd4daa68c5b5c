// Textures: each image's average, found once, and what of a texture the ledger must tell.
#pragma once

#include "convert/gltf/asset.h"
#include "convert/gltf/image.h"
#include "convert/ledger.h"

namespace yarte::convert::gltf {

class Textures {
public:
    Textures(Asset& asset, Ledger& ledger) : asset_(asset), ledger_(ledger) {}

    /// Of the texture that the member `name` of `parent` refers to; all 1 if there is none or it cannot be
    /// read.
    ImageAverage average(const Object& parent, std::string_view name);

private:
    const ImageAverage& imageAverage(const Object& image, std::uint32_t id);
    ImageAverage readImage(const Object& image);

    Asset& asset_;
    Ledger& ledger_;
    std::map<std::uint32_t, ImageAverage> images_;
};

} // namespace yarte::convert::gltf
