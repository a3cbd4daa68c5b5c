#include "convert/povray/sdl/build_exact.h"

#include "convert/povray/sdl/stretch.h"
#include "yarte/scene/referential.h"

#include <algorithm>

namespace yarte::convert::povray::sdl {
namespace {

/// Moves, turns and evenly scales a shape around which there may be axes.
struct Place {
    const Affine& map; ///< in the scene's units
    double scale;

    void centre(Vec3& c) const { c = mapPoint(map, c); }
    void operator()(Sphere& s) const { centre(s.centre), s.radius *= scale; }
    void operator()(Box& b) const { centre(b.centre), b.sides = b.sides * scale; }
    void operator()(Cone& c) const { centre(c.centre), c.radius *= scale, c.height *= scale; }
    void operator()(TruncatedCone& c) const {
        centre(c.centre), c.radius *= scale, c.coneHeight *= scale, c.height *= scale;
    }
    void operator()(Disc& d) const { centre(d.centre), d.radius *= scale; }
    void operator()(Polygon& p) const {
        for (Vec3& v : p.vertices) centre(v);
        if (determinant(map) < 0) std::reverse(p.vertices.begin() + 1, p.vertices.end());
    }
    void operator()(Mesh& m) const {
        const Frame axes = resolveReferential(m.axes);
        m.axes = {mapDirection(map, axes.x) / scale, mapDirection(map, axes.y) / scale,
                  mapDirection(map, axes.z) / scale};
        m.scale *= scale;
        centre(m.translation);
    }
    void operator()(Cylinder& c) const { centre(c.centre), c.radius *= scale, c.height *= scale; }
    void operator()(OpenCylinder& c) const { centre(c.centre), c.radius *= scale, c.height *= scale; }
    void operator()(Frustum& f) const {
        centre(f.centre), f.baseRadius *= scale, f.topRadius *= scale, f.height *= scale;
    }
    void operator()(Plane& p) const {
        const Vec3 n = unit(mapNormal(map, p.normal));
        p = {n, dot(n, mapPoint(map, unit(p.normal) * p.distance))};
    }
};

} // namespace

std::optional<ExactBody> place(const Shape& shape, const Affine& a, const std::optional<Referential>& axes,
                               double unitLength) {
    if (a == Affine{}) return ExactBody{shape, axes};
    const Affine map{a.x, a.y, a.z, a.t / unitLength};
    const bool isPolygon = std::holds_alternative<Polygon>(shape);
    const Similarity similarity = axes ? Similarity{} : similarityOf(map);
    if (similarity.error > rounding && !isPolygon) return std::nullopt;
    const bool isMirrored = determinant(map) < 0;
    if (isMirrored && std::holds_alternative<Mesh>(shape)) return std::nullopt;
    ExactBody result{shape, axes};
    std::visit(Place{map, similarity.scale}, result.shape);
    if (axes || !takesReferential(shape)) return result;
    const double s = similarity.scale;
    const Vec3 z = isMirrored ? -map.z : map.z; // these shapes are the same on both sides of z = 0
    const bool isTurned = map.x / s != Vec3{1, 0, 0} || map.y / s != Vec3{0, 1, 0};
    if (isTurned) result.referential = Referential{map.x / s, map.y / s, z / s};
    return result;
}

} // namespace yarte::convert::povray::sdl
