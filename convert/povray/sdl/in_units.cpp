#include "convert/povray/sdl/in_units.h"

#include <utility>

namespace yarte::convert::povray::sdl {
namespace {

struct Divide {
    double unit;

    void all() const {}
    template <class... Rest>
    void all(Vec3& v, Rest&... rest) const {
        v = v / unit, all(rest...);
    }
    template <class... Rest>
    void all(double& length, Rest&... rest) const {
        length /= unit, all(rest...);
    }

    void operator()(Sphere& s) const { all(s.centre, s.radius); }
    void operator()(Box& b) const { all(b.centre, b.sides); }
    void operator()(Cone& c) const { all(c.centre, c.radius, c.height); }
    void operator()(TruncatedCone& c) const { all(c.centre, c.radius, c.coneHeight, c.height); }
    void operator()(Disc& d) const { all(d.centre, d.radius); }
    void operator()(Polygon& p) const {
        for (Vec3& v : p.vertices) all(v);
    }
    /// The mesh's own vertices stay as they are.
    void operator()(Mesh& m) const { all(m.scale, m.translation); }
    void operator()(Cylinder& c) const { all(c.centre, c.radius, c.height); }
    void operator()(OpenCylinder& c) const { all(c.centre, c.radius, c.height); }
    void operator()(Frustum& f) const { all(f.centre, f.baseRadius, f.topRadius, f.height); }
    void operator()(Plane& p) const { all(p.distance); }
};

} // namespace

Shape inUnits(Shape shape, double unit) {
    if (unit != 1) std::visit(Divide{unit}, shape);
    return shape;
}

} // namespace yarte::convert::povray::sdl
