// The first camera of the scene.
#pragma once

#include "convert/gltf/asset.h"
#include "convert/gltf/extent.h"
#include "convert/ledger.h"
#include "yarte/scene/scene.h"

namespace yarte::convert::gltf {

struct ReadCamera {
    Camera camera;
    Resolution resolution; ///< with the camera's aspect, as nearly as whole pixels can
};

/// The first perspective camera of the scene, otherwise the first orthographic one, from which the centre of
/// `extent` is seen in the same size. Nothing if there is none.
std::optional<ReadCamera> readCamera(Asset&, const Extent& extent, Ledger&);

} // namespace yarte::convert::gltf
