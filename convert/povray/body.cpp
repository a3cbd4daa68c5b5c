#include "convert/povray/body.h"

#include "convert/povray/eye.h"
#include "convert/povray/limits.h"
#include "convert/povray/mesh.h"
#include "convert/povray/sdl_text.h"
#include "yarte/base/number.h"
#include "yarte/scene/referential.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <variant>

namespace yarte::convert::povray {
namespace {

/// Axes as written are kept beside the rotation that they stand for, unless they are that rotation.
std::string writtenAxes(const Referential& r, std::size_t body) {
    const Frame axes = resolveReferential(r);
    if (r.z && r.x == axes.x && r.y == axes.y && *r.z == axes.z) return {};
    return fmt::format(
        "#declare Axes_{} = array[{}] {{ {}, {}{} }} // as written; below, the rotation nearest to them\n",
        body + 1, r.z ? 3 : 2, sdl(r.x), sdl(r.y), r.z ? ", " + sdl(*r.z) : "");
}

struct Writer {
    const BodyWriting& writing;
    const Body& body;
    std::size_t index;
    const std::string& material;

    std::string object(std::string_view kind, const std::string& head, const std::string& tail = "") const {
        return fmt::format("\n// {}\n{}{}    material {{ {} }}\n{}}}\n",
                           placeOf(kind, body.span, writing.sources), axesDeclaration(), head, material,
                           tail);
    }

    /// A body with a referential is written around the origin, then turned and moved.
    std::string placement(Vec3 centre) const {
        std::string text;
        if (body.referential)
            text = fmt::format("    Yarte_Turn({})\n", sdl(resolveReferential(*body.referential)));
        return text + fmt::format("    translate {}*World_Scale\n", sdl(centre));
    }

    std::string axesDeclaration() const {
        if (const auto* mesh = std::get_if<Mesh>(&body.shape)) return writtenAxes(mesh->axes, index);
        return body.referential ? writtenAxes(*body.referential, index) : "";
    }

    /// POV-Ray takes a camera behind a disc, or between the rims of an open cone or cylinder, to be inside;
    /// the inverse body is not.
    std::string outsideOfEye() const {
        const bool isTransmissive = transmits(writing.scene.materials[body.material.index]);
        return isTransmissive && wouldHoldEye(body, writing.scene.camera.position) ? "    inverse\n" : "";
    }

    std::string operator()(const Sphere& s) const {
        return object("sphere", fmt::format("sphere {{\n    {}*World_Scale, {}*World_Scale\n", sdl(s.centre),
                                            printNumber(s.radius)));
    }

    std::string operator()(const Box& b) const {
        return object("box", fmt::format("box {{\n    -{0}/2*World_Scale, {0}/2*World_Scale\n", sdl(b.sides)),
                      placement(b.centre));
    }

    std::string operator()(const Cone& c) const {
        return object("cone",
                      fmt::format("cone {{\n    <0, 0, 0>, {}*World_Scale, {}*World_Scale*y, 0\n",
                                  printNumber(c.radius), printNumber(c.height)),
                      placement(c.centre));
    }

    std::string operator()(const TruncatedCone& c) const {
        return object("truncated cone",
                      fmt::format("object {{\n    Yarte_Truncated_Cone({}, {}, {})\n", printNumber(c.radius),
                                  printNumber(c.coneHeight), printNumber(c.height)),
                      outsideOfEye() + placement(c.centre));
    }

    std::string operator()(const Disc& d) const {
        return object("disc",
                      fmt::format("disc {{\n    <0, 0, 0>, y, {}*World_Scale\n", printNumber(d.radius)),
                      outsideOfEye() + placement(d.centre));
    }

    std::string operator()(const Polygon& p) const {
        std::string vertices;
        for (const Vec3 v : p.vertices) vertices += (vertices.empty() ? "" : ", ") + sdl(v);
        reportPolygon(p, index, writing.ledger);
        return object("polygon", fmt::format("object {{\n    Yarte_Polygon(array[{}] {{ {} }})\n",
                                             p.vertices.size(), vertices));
    }

    std::string operator()(const Mesh& m) const {
        reportMesh(writing.scene, m, writing.plain, index, writing.ledger);
        return object("mesh", meshObject(writing.scene, body, m, writing.plain));
    }

    static std::string cylinder(double radius, double height) {
        return fmt::format("cylinder {{\n    <0, 0, 0>, {}*World_Scale*y, {}*World_Scale\n",
                           printNumber(height), printNumber(radius));
    }

    std::string operator()(const Cylinder& c) const {
        return object("cylinder", cylinder(c.radius, c.height), placement(c.centre));
    }

    std::string operator()(const OpenCylinder& c) const {
        return object("open cylinder", cylinder(c.radius, c.height) + "    open\n",
                      outsideOfEye() + placement(c.centre));
    }

    std::string operator()(const Frustum& f) const {
        return object(
            "frustum",
            fmt::format("cone {{\n    <0, 0, 0>, {}*World_Scale, {}*World_Scale*y, {}*World_Scale\n",
                        printNumber(f.baseRadius), printNumber(f.height), printNumber(f.topRadius)),
            placement(f.centre));
    }

    /// POV-Ray refuses a normal shorter than 1e-10.
    std::string operator()(const Plane& p) const {
        reportPlane(writing.scene, index, writing.ledger);
        const double size = std::max({std::abs(p.normal.x), std::abs(p.normal.y), std::abs(p.normal.z)});
        const Vec3 normal = size > 1e-9 && size < 1e100 ? p.normal : unitVector(p.normal);
        return object(
            "plane", fmt::format("plane {{\n    {}, {}*World_Scale\n", sdl(normal), printNumber(p.distance)));
    }
};

} // namespace

std::string bodyText(std::size_t index, const std::string& material, const BodyWriting& writing) {
    const Body& body = writing.scene.bodies[index];
    return std::visit(Writer{writing, body, index, material}, body.shape);
}

} // namespace yarte::convert::povray
