// What camera rays meet, by the kernels that pictures are made with and in their precision: to measure how
// far from the truth these are.
#pragma once

#include "yarte/base/vec3.h"
#include "yarte/trace/render_tile.h"

#include <vector>

namespace yarte {

struct CameraHit {
    int body = -1;       ///< as an index into Scene::bodies; -1: nothing is met
    double distance = 0; ///< along the ray
    Vec3 normal;         ///< turned to the viewer; in float its length is 1 but for rounding
};

/// Of each pixel of the tile, row by row.
std::vector<CameraHit> cameraHits(const World&, Tile);

} // namespace yarte
