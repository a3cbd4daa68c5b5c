#include "convert/curved_shapes.h"

#include "convert/tessellate.h"
#include "yarte/base/number.h"
#include "yarte/scene/referential.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <type_traits>
#include <variant>

namespace yarte::convert {
namespace {

/// All that `tessellateCone` makes: of a bottom radius alone, without a height, a disc. No kind but the
/// sphere is anything else.
struct Curved {
    const char* kind = nullptr;
    double bottom = 0, top = 0, height = 0;
    Lids lids;
    Vec3 centre; ///< of the base
};

/// Nothing for flat shapes.
std::optional<Curved> curved(const Shape& shape) {
    return std::visit(
        []<class S>(const S& s) -> std::optional<Curved> {
            if constexpr (std::is_same_v<S, Sphere>)
                return Curved{"sphere", s.radius, 0, 0, {}, s.centre};
            else if constexpr (std::is_same_v<S, Disc>)
                return Curved{"disc", s.radius, 0, 0, {}, s.centre};
            else if constexpr (std::is_same_v<S, Cone>)
                return Curved{"cone", s.radius, 0, s.height, {.bottom = true}, s.centre};
            else if constexpr (std::is_same_v<S, TruncatedCone>)
                return Curved{"truncated cone", s.radius, s.radius * (s.coneHeight - s.height) / s.coneHeight,
                              s.height,         {},       s.centre};
            else if constexpr (std::is_same_v<S, Cylinder>)
                return Curved{"cylinder", s.radius, s.radius, s.height, {true, true}, s.centre};
            else if constexpr (std::is_same_v<S, OpenCylinder>)
                return Curved{"open cylinder", s.radius, s.radius, s.height, {}, s.centre};
            else if constexpr (std::is_same_v<S, Frustum>)
                return Curved{"frustum", s.baseRadius, s.topRadius, s.height, {true, true}, s.centre};
            else {
                static_assert(std::is_same_v<S, Box> || std::is_same_v<S, Polygon> ||
                              std::is_same_v<S, Mesh> || std::is_same_v<S, Plane>);
                return std::nullopt;
            }
        },
        shape);
}

Tessellation tessellate(const Shape& shape, const Curved& c, double chordError) {
    if (std::holds_alternative<Sphere>(shape)) return tessellateSphere(c.bottom, chordError);
    if (std::holds_alternative<Disc>(shape)) return tessellateDisc(c.bottom, chordError);
    return tessellateCone(c.bottom, c.top, c.height, c.lids, chordError);
}

MeshData meshOf(const Tessellation& t) {
    MeshData data;
    for (const Vec3f& p : t.positions) data.vertices.push_back(widened(p));
    for (const Vec3f& n : t.normals) data.normals.push_back(widened(n));
    for (const auto& triangle : t.triangles) {
        data.corners.insert(data.corners.end(), triangle.begin(), triangle.end());
        data.faceStarts.push_back(static_cast<std::uint32_t>(data.corners.size()));
    }
    if (!data.normals.empty()) data.cornerNormals = data.corners;
    return data;
}

} // namespace

Scene withMeshesForCurvedShapes(Scene scene, std::optional<double> chordError, Ledger& ledger) {
    struct Made {
        MeshId mesh;
        double deviation;
    };
    std::map<std::string, Made> made; // by kind and measures
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        Body& body = scene.bodies[i];
        const auto c = curved(body.shape);
        if (!c) continue;
        const std::string key = fmt::format("{} {} {} {}", c->kind, c->bottom, c->top, c->height);
        auto found = made.find(key);
        if (found == made.end()) {
            const double error = chordError.value_or(defaultChordError * std::max(c->bottom, c->top));
            const Tessellation t = tessellate(body.shape, *c, error);
            const MeshId id{static_cast<std::uint32_t>(scene.meshes.size())};
            scene.meshes.push_back(meshOf(t));
            found = made.emplace(key, Made{id, t.deviation}).first;
        }
        const auto [mesh, deviation] = found->second;
        const Frame axes = body.referential ? resolveReferential(*body.referential) : Frame{};
        body.shape = Mesh{mesh, 1, {axes.x, axes.y, axes.z}, c->centre + axes.y * (c->height / 2)};
        body.referential.reset();
        ledger.add({fmt::format("body {} ({})", i + 1, c->kind), "surface", Action::approximated,
                    fmt::format("{} triangles", scene.meshes[mesh.index].faceCount()), deviation});
    }
    return scene;
}

} // namespace yarte::convert
