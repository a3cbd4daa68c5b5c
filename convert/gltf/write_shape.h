// A body's shape as glTF shows it: triangles around the shape's middle, and where they stand.
#pragma once

#include "convert/format.h"
#include "convert/gltf/geometry_print.h"
#include "convert/gltf/write_json.h"
#include "convert/tessellate.h"
#include "yarte/base/frame.h"

namespace yarte::convert::gltf {

struct ShownShape {
    std::string kind; ///< "truncated cone"
    std::string key;  ///< equal: the same triangles, so that bodies can share them
    Frame axes;
    double scale = 1;
    Vec3 middle;
    Json implicit; ///< a shape of KHR_implicit_shapes around the middle; null where it has none that is equal

    Transform world() const { return {axes.x * scale, axes.y * scale, axes.z * scale, middle}; }
};

ShownShape shownShape(const Body&, std::size_t body);

/// Farthest that a chord may be from the surface, where the user does not say: a part of the radius.
inline constexpr double defaultChordError = 1e-3;

/// The triangles around the middle. `chordError`: in scene units.
Tessellation tessellate(const Body&, const Scene&, Vec3 middle, std::optional<double> chordError);

} // namespace yarte::convert::gltf
