// Geometries: the triangles of all bodies, those of equal shapes once.
#pragma once

#include "convert/gltf/write_output.h"
#include "convert/gltf/write_shape.h"

namespace yarte::convert::gltf {

struct Geometry {
    GeometryPrint print;
    std::size_t triangles = 0;
    double deviation = 0;                ///< as Tessellation's
    Vec3 low, high;                      ///< its box, around the shape's middle
    bool isSaid = false;                 ///< of a mesh: the triangles alone tell it to the last bit
    Json primitive;                      ///< attributes and indices, without material
    std::optional<std::size_t> implicit; ///< index into the shapes of KHR_implicit_shapes
};

class Geometries {
public:
    Geometries(const Scene& scene, std::optional<double> chordError, Output& output)
        : scene_(scene), chordError_(chordError), output_(output) {}

    const Geometry& of(const Body&, const ShownShape&);

private:
    Geometry make(const Body&, const ShownShape&);

    const Scene& scene_;
    std::optional<double> chordError_;
    Output& output_;
    std::map<std::string, Geometry> known_; ///< by ShownShape::key
};

inline constexpr const char* implicitShapes = "KHR_implicit_shapes";

} // namespace yarte::convert::gltf
