#include "convert/gltf/write_shape.h"

#include "convert/tessellate_polygon.h"
#include "yarte/base/number.h"
#include "yarte/scene/referential.h"

#include <fmt/format.h>

#include <algorithm>
#include <variant>

namespace yarte::convert::gltf {
namespace {

template <class... Values>
std::string key(const char* kind, Values... values) {
    std::string text = kind;
    ((text += ' ' + printNumber(values)), ...);
    return text;
}

struct Shown {
    const Body& body;
    std::size_t index;

    Frame axes() const { return body.referential ? resolveReferential(*body.referential) : Frame{}; }

    ShownShape operator()(const Sphere& s) const {
        return {
            "sphere", key("sphere", s.radius),
            {},       1,
            s.centre, object({{"type", json("sphere")}, {"sphere", object({{"radius", json(s.radius)}})}})};
    }
    ShownShape operator()(const Box& b) const {
        return {"box",    key("box", b.sides.x, b.sides.y, b.sides.z),
                axes(),   1,
                b.centre, object({{"type", json("box")}, {"box", object({{"size", json(b.sides)}})}})};
    }
    ShownShape operator()(const Cone& c) const {
        return {"cone",
                key("cone", c.radius, c.height),
                axes(),
                1,
                c.centre + axes().y * (c.height / 2),
                object({{"type", json("cylinder")},
                        {"cylinder", object({{"height", json(c.height)},
                                             {"radiusBottom", json(c.radius)},
                                             {"radiusTop", json(0.0)}})}})};
    }
    ShownShape operator()(const TruncatedCone& c) const {
        return {"truncated cone",
                key("truncated", c.radius, c.coneHeight, c.height),
                axes(),
                1,
                c.centre + axes().y * (c.height / 2),
                {}};
    }
    ShownShape operator()(const Disc& d) const {
        return {"disc", key("disc", d.radius), axes(), 1, d.centre, {}};
    }
    ShownShape operator()(const Polygon& p) const {
        Vec3 low = p.vertices.at(0), high = low;
        for (const Vec3 v : p.vertices) {
            low = {std::min(low.x, v.x), std::min(low.y, v.y), std::min(low.z, v.z)};
            high = {std::max(high.x, v.x), std::max(high.y, v.y), std::max(high.z, v.z)};
        }
        return {"polygon", fmt::format("polygon {}", index), {}, 1, low + (high - low) / 2, {}};
    }
    ShownShape operator()(const yarte::Mesh& m) const {
        return {
            "mesh", fmt::format("mesh {}", m.mesh.index), resolveReferential(m.axes), m.scale, m.translation,
            {}};
    }
};

struct Tessellate {
    const Scene& scene;
    Vec3 middle;
    std::optional<double> chordError;

    double error(double radius) const { return chordError.value_or(defaultChordError * radius); }

    Tessellation operator()(const Sphere& s) const { return tessellateSphere(s.radius, error(s.radius)); }
    Tessellation operator()(const Box& b) const { return tessellateBox(b.sides); }
    Tessellation operator()(const Cone& c) const {
        return tessellateCone(c.radius, 0, c.height, true, error(c.radius));
    }
    Tessellation operator()(const TruncatedCone& c) const {
        const double top = c.radius * (c.coneHeight - c.height) / c.coneHeight;
        return tessellateCone(c.radius, top, c.height, false, error(c.radius));
    }
    Tessellation operator()(const Disc& d) const { return tessellateDisc(d.radius, error(d.radius)); }
    Tessellation operator()(const Polygon& p) const { return tessellatePolygon(p.vertices, middle); }
    Tessellation operator()(const yarte::Mesh& m) const { return tessellateMesh(scene.meshes[m.mesh.index]); }
};

} // namespace

ShownShape shownShape(const Body& body, std::size_t index) {
    return std::visit(Shown{body, index}, body.shape);
}

Tessellation tessellate(const Body& body, const Scene& scene, Vec3 middle, std::optional<double> chordError) {
    return std::visit(Tessellate{scene, middle, chordError}, body.shape);
}

} // namespace yarte::convert::gltf
