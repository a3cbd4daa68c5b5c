// AOV ("arbitrary output variables"): what the tracer knows of a pixel besides its colour. Reports on the
// difference of two pictures find its cause by it. Plain code, ray by ray: it is for looking into a picture,
// not for making one. The channels in a file, with their meanings, are listed in yarte/README.md.
#pragma once

#include "yarte/base/colour.h"
#include "yarte/base/vec3.h"
#include "yarte/trace/render_tile.h"

#include <span>
#include <vector>

namespace yarte {

/// One light as seen from the camera ray's hit.
struct AovLight {
    Colour arriving;    ///< part of its light that shadows leave; black too where it is behind the surface
    double lambert = 0; ///< N.L, 0 where the light is behind the surface
    double mirror = 0;  ///< R.L, 0 where negative: Phong's base
};

/// What a body adds to a pixel, whichever rays met it: sums over these rays, each with its weight, the
/// product of the cr and of the ct and tints on its way. The pixel's colour changes by so much when one of
/// the body's properties grows by 1.
struct AovVisit {
    int body = -1;       ///< index into Scene::bodies
    bool isBack = false; ///< of a body with back colours: these are those of its back
    Colour weight;       ///< ambient colour
    Colour lit;          ///< diffuse colour
    Colour highlight;    ///< specular colour
    Colour reflected;    ///< cr; mirrored rays are followed for this where cr is 0, too
    Colour transmitted;  ///< ct
};

struct AovPixel {
    int body = -1;                ///< met by the camera ray, as an index into Scene::bodies; -1: none
    double depth = -1;            ///< distance along the camera ray; -1: infinite
    Vec3 normal;                  ///< unit, turned to the viewer; 0 if nothing is met
    bool isBack = false;          ///< the body's back side is seen
    std::vector<AovLight> lights; ///< by index of Scene::lights

    int reflectedBody = -1;   ///< first met by the mirrored ray of a body with cr > 0
    int transmittedBody = -1; ///< first met by the ray transmitted by a body with ct > 0

    Colour backgroundWeight;        ///< sum of the weights of the rays that met nothing
    std::vector<Colour> lightShare; ///< what each light adds to the pixel's colour
    std::vector<AovVisit> visits;   ///< one for each body (and side, if they differ), the heaviest first

    std::vector<bool> secondary; ///< by body: met by a ray other than the camera ray
    std::vector<bool> casting;   ///< by body: lies between a light and a point that a ray met
};

/// Of pixel (x, y) of the image; `lights` are the scene's.
AovPixel aovPixel(const World&, std::span<const Light> lights, int x, int y);

} // namespace yarte
