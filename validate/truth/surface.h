// Surfaces: where a line first meets a shape of the scene language, from the shape's definition
// (yarte/LANGUAGE.md) in Real. Written for being evidently right: it shares nothing with the renderer.
#pragma once

#include "validate/truth/real.h"
#include "yarte/scene/scene.h"

#include <optional>
#include <vector>

namespace yarte::validate {

struct RealRay {
    RealVec3 origin, direction; ///< of unit length
    RealVec3 at(const Real& t) const { return origin + direction * t; }
};

struct SurfaceHit {
    Real distance;   ///< > 0
    RealVec3 normal; ///< unit, to either side
};

/// A ball that holds a surface, for leaving out what is far from a ray; without limit for a plane.
struct Ball {
    Vec3 centre;
    double radius = 0;
    bool isUnbounded = false;
};

/// One face of a polygon or mesh, its vertices where they lie in the world.
struct FaceSurface {
    std::vector<RealVec3> vertices;
    std::vector<RealVec3> normals; ///< unit, of the vertices of a smooth triangle; empty: flat
};

/// Any other shape: `shape` is no polygon or mesh.
struct ShapeSurface {
    Shape shape;
    RealVec3 axes[3]; ///< the rotation that the scene's axes stand for, as rounded to double
};

std::optional<SurfaceHit> firstHit(const FaceSurface&, const RealRay&);
std::optional<SurfaceHit> firstHit(const ShapeSurface&, const RealRay&);

Ball ballAround(const std::vector<Vec3>& vertices);
Ball ballAround(const ShapeSurface&);

} // namespace yarte::validate
