#include "convert/gltf/write_shape.h"

#include "convert/tessellate_polygon.h"
#include "yarte/base/number.h"
#include "yarte/scene/referential.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

namespace yarte::convert::gltf {
namespace {

template <class... Values>
std::string key(const char* kind, Values... values) {
    std::string text = kind;
    ((text += ' ' + printNumber(values)), ...);
    return text;
}

/// A cone, frustum or cylinder.
Json implicitCylinder(double bottom, double top, double height) {
    return object(
        {{"type", json("cylinder")},
         {"cylinder",
          object({{"height", json(height)}, {"radiusBottom", json(bottom)}, {"radiusTop", json(top)}})}});
}

/// Turns +y to the normal.
Frame axesOf(const Plane& plane) {
    const Vec3 n = unitVector(plane.normal);
    const Vec3 x = normalised(cross(n, std::abs(n.z) < 0.6 ? Vec3{0, 0, 1} : Vec3{1, 0, 0}));
    return {x, n, cross(x, n)};
}

struct Shown {
    const Body& body;
    std::size_t index;
    const Surround& around;

    Frame axes() const { return body.referential ? resolveReferential(*body.referential) : Frame{}; }

    ShownShape operator()(const Sphere& s) const {
        return {"sphere",
                key("sphere", s.radius),
                {},
                1,
                s.centre,
                0,
                object({{"type", json("sphere")}, {"sphere", object({{"radius", json(s.radius)}})}})};
    }
    ShownShape operator()(const Box& b) const {
        return {"box",
                key("box", b.sides.x, b.sides.y, b.sides.z),
                axes(),
                1,
                b.centre,
                0,
                object({{"type", json("box")}, {"box", object({{"size", json(b.sides)}})}})};
    }
    ShownShape operator()(const Cone& c) const {
        return {
            "cone", key("cone", c.radius, c.height),        axes(), 1, c.centre + axes().y * (c.height / 2),
            0,      implicitCylinder(c.radius, 0, c.height)};
    }
    ShownShape operator()(const TruncatedCone& c) const {
        return {"truncated cone",
                key("truncated", c.radius, c.coneHeight, c.height),
                axes(),
                1,
                c.centre + axes().y * (c.height / 2),
                0,
                {}};
    }
    ShownShape operator()(const Disc& d) const {
        return {"disc", key("disc", d.radius), axes(), 1, d.centre, 0, {}};
    }
    ShownShape operator()(const Polygon& p) const {
        Vec3 low = p.vertices.at(0), high = low;
        for (const Vec3 v : p.vertices) {
            low = {std::min(low.x, v.x), std::min(low.y, v.y), std::min(low.z, v.z)};
            high = {std::max(high.x, v.x), std::max(high.y, v.y), std::max(high.z, v.z)};
        }
        return {"polygon", fmt::format("polygon {}", index), {}, 1, low + (high - low) / 2, 0, {}};
    }
    ShownShape operator()(const yarte::Mesh& m) const {
        return {"mesh",
                fmt::format("mesh {}", m.mesh.index),
                resolveReferential(m.axes),
                m.scale,
                m.translation,
                0,
                {}};
    }
    ShownShape operator()(const Cylinder& c) const {
        return {"cylinder",
                key("cylinder", c.radius, c.height),
                axes(),
                1,
                c.centre + axes().y * (c.height / 2),
                0,
                implicitCylinder(c.radius, c.radius, c.height)};
    }
    ShownShape operator()(const OpenCylinder& c) const {
        return {"open cylinder",
                key("open cylinder", c.radius, c.height),
                axes(),
                1,
                c.centre + axes().y * (c.height / 2),
                0,
                {}};
    }
    ShownShape operator()(const Frustum& f) const {
        return {"frustum",
                key("frustum", f.baseRadius, f.topRadius, f.height),
                axes(),
                1,
                f.centre + axes().y * (f.height / 2),
                0,
                implicitCylinder(f.baseRadius, f.topRadius, f.height)};
    }
    /// Numbers near the limits of double stay such.
    ShownShape operator()(const Plane& p) const {
        constexpr double most = std::numeric_limits<float>::max();
        const double side = around.longestSide();
        const double reach = std::min(planeReach * (side > 0 ? side : 1), most);
        const Vec3 foot = footOn(p, around.centre());
        const Vec3 middle = isFinite(foot) ? foot : unitVector(p.normal) * p.distance;
        return {"plane",
                key("plane", reach),
                axesOf(p),
                1,
                middle,
                reach,
                object({{"type", json("plane")}, {"plane", object({})}})};
    }
};

struct Tessellate {
    const Scene& scene;
    const ShownShape& shown;
    std::optional<double> chordError;

    double error(double radius) const { return chordError.value_or(defaultChordError * radius); }

    Tessellation operator()(const Sphere& s) const { return tessellateSphere(s.radius, error(s.radius)); }
    Tessellation operator()(const Box& b) const { return tessellateBox(b.sides); }
    Tessellation operator()(const Cone& c) const {
        return tessellateCone(c.radius, 0, c.height, {.bottom = true}, error(c.radius));
    }
    Tessellation operator()(const TruncatedCone& c) const {
        const double top = c.radius * (c.coneHeight - c.height) / c.coneHeight;
        return tessellateCone(c.radius, top, c.height, {}, error(c.radius));
    }
    Tessellation operator()(const Disc& d) const { return tessellateDisc(d.radius, error(d.radius)); }
    Tessellation operator()(const Polygon& p) const { return tessellatePolygon(p.vertices, shown.middle); }
    Tessellation operator()(const yarte::Mesh& m) const { return tessellateMesh(scene.meshes[m.mesh.index]); }
    Tessellation operator()(const Cylinder& c) const {
        return tessellateCone(c.radius, c.radius, c.height, {true, true}, error(c.radius));
    }
    Tessellation operator()(const OpenCylinder& c) const {
        return tessellateCone(c.radius, c.radius, c.height, {}, error(c.radius));
    }
    Tessellation operator()(const Frustum& f) const {
        return tessellateCone(f.baseRadius, f.topRadius, f.height, {true, true},
                              error(std::max(f.baseRadius, f.topRadius)));
    }
    Tessellation operator()(const Plane&) const { return tessellateSquare(shown.reach); }
};

} // namespace

ShownShape shownShape(const Body& body, std::size_t index, const Surround& around) {
    return std::visit(Shown{body, index, around}, body.shape);
}

Tessellation tessellate(const Body& body, const ShownShape& shown, const Scene& scene,
                        std::optional<double> chordError) {
    return std::visit(Tessellate{scene, shown, chordError}, body.shape);
}

} // namespace yarte::convert::gltf
