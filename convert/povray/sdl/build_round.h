// Spheres, boxes, cones, discs, tori and planes under affine maps: YARTE's shape wherever one is what POV-Ray
// shows or as near to it as triangles would be, otherwise a mesh.
#pragma once

#include "convert/povray/sdl/model.h"

#include <variant>

namespace yarte::convert::povray::sdl {

/// What becomes of a shape.
struct Built {
    std::variant<std::monostate, Shape, MeshData> what; ///< nothing: no ray meets it
    std::optional<Referential> referential;
    double deviation = 0; ///< of its surface from the mapped one
    std::string why;      ///< of nothing: the reason; of a mesh or a deviation: what it is
};

/// How far surfaces may be off: in world units, or as a part of their size.
struct Tolerance {
    std::optional<double> chordError;
    double of(double size) const { return chordError ? *chordError : relative * size; }
    static constexpr double relative = 1e-3;
};

Built build(const SphereShape&, const Affine&, Tolerance);
Built build(const BoxShape&, const Affine&);
Built build(const ConeShape&, const Affine&, Tolerance);
Built build(const DiscShape&, const Affine&, Tolerance);
Built build(const TorusShape&, const Affine&, Tolerance);
Built build(const PlaneShape&, const Affine&);

} // namespace yarte::convert::povray::sdl
