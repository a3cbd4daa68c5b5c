// TrueScene: what camera rays meet in a scene, exactly but for the fiftieth digit.
#pragma once

#include "validate/truth/surface.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace yarte::validate {

struct TrueHit {
    int body = -1;   ///< index into Scene::bodies
    Real distance;   ///< from the camera
    RealVec3 normal; ///< unit, to either side
};

/// Faces of meshes, and bodies of other shapes: each is looked at for every ray.
std::size_t surfaceCount(const Scene&);

class TrueScene {
public:
    /// With a picture of `resolution`.
    TrueScene(Scene, Resolution resolution);

    /// Through the centre of a pixel, row 0 on top.
    RealRay ray(int x, int y) const;

    /// Of surfaces at equal distances the first one in the scene's file.
    std::optional<TrueHit> firstHit(const RealRay&) const;

private:
    /// What is looked at for every ray; the surface itself is made when a ray passes through its ball.
    struct Surface {
        Ball ball;
        std::size_t body, face;
    };
    void addBody(std::size_t body);
    std::optional<SurfaceHit> hit(const Surface&, const RealRay&) const;

    Scene scene_;
    Resolution resolution_;
    RealVec3 eye_, forward_, right_, up_; ///< right and up: the picture's full width and height at distance 1
    std::vector<Surface> surfaces_;       ///< in the file's order
};

} // namespace yarte::validate
