// CameraRays: one ray through the centre of each pixel (decision D5).
#pragma once

#include "yarte/scene/scene.h"
#include "yarte/trace/ray.h"

namespace yarte::trace {

/// Right-handed: forward, right = forward x up, up = right x forward; the image spans 2 tan(h) by 2 tan(v) at
/// distance 1, h and v being the half-angles (decision D1).
struct CameraRays {
    Vec3 position, forward, right, up; ///< right and up: the image's full width and height at distance 1
    int width = 1, height = 1;

    CameraRays() = default;
    CameraRays(const Camera&, Resolution);

    /// Row 0 on top. The pixel need not lie in the image.
    Ray through(int x, int y) const {
        const double u = (x + 0.5) / width - 0.5, v = 0.5 - (y + 0.5) / height;
        return {position, normalised(forward + u * right + v * up), {}};
    }
};

} // namespace yarte::trace
