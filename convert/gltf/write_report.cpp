#include "convert/gltf/write_report.h"

#include "convert/gltf/write_view.h"
#include "yarte/base/number.h"

#include <fmt/format.h>

namespace yarte::convert::gltf {
namespace {

class Report {
public:
    Report(const Scene& scene, const Written& written, Ledger& ledger)
        : scene_(scene), written_(written), ledger_(ledger) {}

    void settings() {
        where_ = "image";
        row("resolution and gamma", Action::extras, "glTF says nothing of pictures");
        where_ = "scene";
        row("background and recursion", Action::extras, "glTF says nothing of rendering");
        if (!scene_.bodies.empty()) row("order of bodies", Action::extras, "nodes have none that tools keep");
        where_ = "camera";
        row("position", Action::exact, "");
        row("focus and up vector", Action::extras, "shown as the direction that they mean");
        row("apertures", Action::extras, "shown as yfov and aspectRatio; few viewers heed the latter");
    }

    void lights() {
        for (std::size_t i = 0; i < scene_.lights.size(); ++i) {
            where_ = fmt::format("light {}", i + 1);
            row("position", Action::exact, "");
            row("brightness", Action::extras,
                fmt::format("shown as {:.6g} cd with fall-off, the same at the middle of the bodies",
                            intensityOf(scene_.lights[i], written_.extent)));
        }
    }

    void materials() {
        for (std::size_t i = 0; i < scene_.materials.size(); ++i) {
            where_ = fmt::format("material {}", i + 1);
            row("everything", Action::extras,
                written_.isUsed[i] ? "shown as the metallic-roughness material nearest to it"
                                   : "no body has it: not shown");
        }
    }

    void meshes() {
        for (std::size_t i = 0; i < scene_.meshes.size(); ++i) {
            where_ = fmt::format("mesh {}", i + 1);
            row("file name", Action::extras, scene_.meshes[i].path);
            row("vertices, faces and normals", written_.isSaid[i] ? Action::exact : Action::extras,
                written_.isSaid[i] ? "" : "shown in float32, as triangles, with unit normals");
        }
    }

    void bodies() {
        for (std::size_t i = 0; i < written_.bodies.size(); ++i) {
            where_ = fmt::format("body {}", i + 1);
            body(written_.bodies[i]);
        }
    }

private:
    void body(const ShownBody& shown) {
        const Body& b = shown.body;
        row("material", Action::exact, "");
        if (const auto* mesh = std::get_if<yarte::Mesh>(&b.shape);
            mesh && written_.isSaid[mesh->mesh.index]) {
            row("shape", Action::exact, "");
        } else if (isPlane(b)) {
            row("shape", Action::extras, "shown as a square");
            row("extent", Action::approximated,
                fmt::format("infinite; shown up to {:.3g} from the middle", shown.shape.reach));
        } else {
            row("shape", Action::extras,
                fmt::format("shown as {} triangles, not farther from it than the bound",
                            shown.geometry.triangles),
                shown.shape.scale * shown.geometry.deviation);
        }
        row("place", Action::extras, "shown in place; kept as it was written");
        if (b.referential) row("axes", Action::extras, "shown as the nearest rotation");
        if (b.back) row("back colours", Action::extras, "the back is shown as the front");
    }

    void row(const char* property, Action action, std::string detail, std::optional<double> bound = {}) {
        ledger_.add({where_, property, action, std::move(detail), bound});
    }

    const Scene& scene_;
    const Written& written_;
    Ledger& ledger_;
    std::string where_;
};

/// The deviation is no loss, as the shapes are in extras; but users of other programs want to know.
void tellDeviation(const std::vector<ShownBody>& bodies, Diagnostics& diagnostics) {
    std::size_t curved = 0, worst = 0;
    double most = 0;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const auto& [body, shape, geometry] = bodies[i];
        if (std::holds_alternative<yarte::Mesh>(body.shape) || std::holds_alternative<Polygon>(body.shape) ||
            std::holds_alternative<Box>(body.shape) || isPlane(body))
            continue;
        ++curved;
        if (geometry.deviation >= most) most = geometry.deviation, worst = i;
    }
    if (curved == 0) return;
    diagnostics
        .warning("gltf.tessellated",
                 fmt::format(
                     "{} of curved shape shown as triangles, at most {:.3g} from it (body {}); their exact "
                     "shape is in extras",
                     curved == 1 ? "1 body is" : fmt::format("{} bodies are", curved), most, worst + 1))
        .severity = Severity::note;
}

} // namespace

void report(const Scene& scene, const Written& written, Conversion& c) {
    Report rows(scene, written, c.ledger);
    rows.settings();
    rows.lights();
    rows.materials();
    rows.meshes();
    rows.bodies();
    tellDeviation(written.bodies, c.diagnostics);
}

} // namespace yarte::convert::gltf
