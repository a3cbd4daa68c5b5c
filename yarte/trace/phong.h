// Local illumination: ambient, diffuse and Phong's specular term, with shadows (SCENE-LANGUAGE section 2).
#pragma once

#include "yarte/trace/search.h"

namespace yarte::trace {

/// A hit with what shading needs to know of it.
struct SurfacePoint {
    Vec3 position;
    Vec3 normal;         ///< unit, turned to face the viewer
    bool isBack = false; ///< seen from behind: against the normal that the shape or its vertices give
    ElementId element;
    Side viewerSide = Side::outside; ///< of the geometry
};

SurfacePoint surfacePoint(const World&, const Ray&, const Hit&);

/// The mirror direction of `d` about the unit normal `n`.
inline Vec3 mirrored(Vec3 d, Vec3 n) { return normalised(d - 2 * dot(d, n) * n); }

/// A + sum over lights of B (D (N.L) + S max(0, R.L)^n) where N.L > 0, R being the mirror direction of the
/// viewing ray, B the brightness after shadows. Adds the shadow rays it traced to `shadowRays`.
Colour localColour(const World&, const SurfacePoint&, Vec3 mirrorDirection, std::uint64_t& shadowRays);

} // namespace yarte::trace
