// Round shapes as smooth triangles in double precision, for affine maps that leave them no shape of YARTE's.
// All are made in the coordinates of the shape, with the chord error there, and mapped afterwards.
#pragma once

#include "convert/povray/sdl/affine.h"
#include "yarte/scene/mesh_data.h"

namespace yarte::convert::povray::sdl {

/// Triangles; the front of flat and smooth ones is the outside, also after a mirroring map.
struct RoundMesh {
    MeshData data;
    /// No point of either surface is farther than this from the other, before the map.
    double deviation = 0;
};

RoundMesh sphereMesh(Vec3 centre, double radius, double chordError);
/// Around the line from `a` to `b`, with the radii there, of which one may be 0.
RoundMesh coneMesh(Vec3 a, double radiusA, Vec3 b, double radiusB, bool isOpen, double chordError);
/// Its front is where `normal`, which is of unit length, points.
RoundMesh ringMesh(Vec3 centre, Vec3 normal, double radius, double hole, double chordError);
/// Around +y.
RoundMesh torusMesh(double major, double minor, double chordError);

/// Vertices, normals and the order of corners.
void map(MeshData&, const Affine&);

} // namespace yarte::convert::povray::sdl
