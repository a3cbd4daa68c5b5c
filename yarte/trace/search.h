// Searching the world along a ray: the nearest crossing, or what light gets through.
#pragma once

#include "yarte/trace/world.h"

#include <optional>

namespace yarte::trace {

struct Hit {
    double t;
    ElementId element;
    std::uint8_t part;
    bool entering; ///< against the outward normal of the geometry
};

/// The first crossing at t > 0; of two at equal t the one first in the file. Uses the tree if there is one.
std::optional<Hit> nearestHit(const World&, const Ray&);

/// The product of the transmissions of all crossings at t in (0, distance): 0 if one is opaque. A sphere
/// counts twice.
Colour transmittance(const World&, const Ray&, double distance);

/// The same by testing every element: the reference that the tree is tested against.
std::optional<Hit> nearestHitBrute(const World&, const Ray&);
Colour transmittanceBrute(const World&, const Ray&, double distance);

} // namespace yarte::trace
