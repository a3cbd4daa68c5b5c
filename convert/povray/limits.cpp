#include "convert/povray/limits.h"

#include "convert/povray/extent.h"
#include "convert/povray/mesh.h"
#include "yarte/scene/planarity.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace yarte::convert::povray {
namespace {

/// Relative to the size: far above what rounding the vertices gives, far below what a pixel shows.
constexpr double planar = 1e-12;

std::string bodyName(std::size_t body) { return fmt::format("body {}", body + 1); }

} // namespace

void reportScene(const Scene& scene, Ledger& ledger) {
    ledger.add({"image",
                "resolution and gamma",
                Action::extras,
                "constants in the file; POV-Ray takes them from its command line",
                {}});
    ledger.add({"camera", "everything", Action::exact, "explicit vectors", {}});
    if (!scene.lights.empty())
        ledger.add(
            {"lights", "everything", Action::exact, fmt::format("{} point lights", scene.lights.size()), {}});
    ledger.add({"bodies",
                "shape and place",
                Action::exact,
                fmt::format("{} bodies, but for the rows that say otherwise", scene.bodies.size()),
                {}});
}

void reportPolygon(const Polygon& polygon, std::size_t body, Ledger& ledger) {
    const double error = planarity(polygon.vertices).value_or(Planarity{}).error;
    if (error > planar)
        ledger.add({bodyName(body), "vertices", Action::approximated,
                    "moved into one plane; relative to the size", error});
}

void reportPlane(const Scene& scene, std::size_t body, Ledger& ledger) {
    constexpr double farthest = 1e7; // that POV-Ray meets, from where a ray starts
    ledger.add({bodyName(body),
                "extent",
                Action::approximated,
                fmt::format("infinite; POV-Ray sees it up to {:.3g} from where a ray starts",
                            farthest / worldScaleOf(scene)),
                {}});
}

void reportMesh(const Scene& scene, const Mesh& mesh, bool plain, std::size_t body, Ledger& ledger) {
    const MeshData& data = scene.meshes[mesh.mesh.index];
    const auto row = [&](const char* property, Action action, std::string detail,
                         std::optional<double> bound = {}) {
        ledger.add({bodyName(body), property, action, std::move(detail), bound});
    };
    std::size_t flat = 0;
    double worst = 0;
    for (std::size_t f = 0; f < data.faceCount(); ++f) {
        std::vector<Vec3> corners;
        for (const std::uint32_t i : data.face(f)) corners.push_back(data.vertices[i]);
        const auto found = planarity(corners);
        flat += !found;
        if (found) worst = std::max(worst, found->error);
    }
    if (worst > planar)
        row("vertices", Action::approximated, "faces moved into planes; relative to a face's size", worst);
    if (flat > 0) row("faces", Action::dropped, fmt::format("{} have no area", flat));
    if (isRounded(data, plain))
        row("vertices", Action::approximated, "rounded to float32; relative", std::ldexp(1.0, -24));
}

} // namespace yarte::convert::povray
