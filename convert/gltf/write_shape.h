// A body's shape as glTF shows it: triangles around the shape's middle, and where they stand.
#pragma once

#include "convert/format.h"
#include "convert/gltf/geometry_print.h"
#include "convert/gltf/write_json.h"
#include "convert/surround.h"
#include "convert/tessellate.h"
#include "yarte/base/frame.h"

namespace yarte::convert::gltf {

struct ShownShape {
    std::string kind; ///< "truncated cone"
    std::string key;  ///< equal: the same triangles, so that bodies can share them
    Frame axes;
    double scale = 1;
    Vec3 middle;
    double reach = 0; ///< of a plane's square
    Json implicit; ///< a shape of KHR_implicit_shapes around the middle; null where it has none that is equal

    Transform world() const { return {axes.x * scale, axes.y * scale, axes.z * scale, middle}; }
};

/// `around`: the scene's, for planes only.
ShownShape shownShape(const Body&, std::size_t body, const Surround& around);

/// A plane is shown as a square that reaches so many times the scene's longest side from its middle.
inline constexpr double planeReach = 30;

/// The triangles around the middle. `chordError`: in scene units.
Tessellation tessellate(const Body&, const ShownShape&, const Scene&, std::optional<double> chordError);

} // namespace yarte::convert::gltf
