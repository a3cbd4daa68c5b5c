#include "convert/gltf/exact_text.h"

#include "yarte/lang/pmf.h"
#include "yarte/lang/scene_printer.h"
#include "yarte/lang/scene_reader.h"

#include <algorithm>
#include <initializer_list>
#include <string_view>
#include <utility>

namespace yarte::convert::gltf {
namespace {

/// The lines of the scene's canonical text that begin with one of these words.
std::string linesOf(const Scene& scene, std::initializer_list<std::string_view> keywords) {
    const std::string all = printScene(scene);
    std::string lines;
    for (std::string_view rest = all; !rest.empty();) {
        const std::string_view line = rest.substr(0, rest.find('\n') + 1);
        rest.remove_prefix(line.size());
        if (std::ranges::any_of(keywords, [&](std::string_view k) { return line.starts_with(k); }))
            lines += line;
    }
    return lines;
}

MeshData standIn() {
    MeshData mesh;
    mesh.path = meshName;
    mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.corners = {0, 1, 2};
    mesh.faceStarts = {0, 3};
    return mesh;
}

std::string firstError(const Diagnostics& diagnostics) {
    for (const Diagnostic& d : diagnostics.all())
        if (d.severity == Severity::error) return d.message;
    return "unreadable";
}

} // namespace

std::string settingsText(const Scene& scene) {
    Scene only;
    only.resolution = scene.resolution;
    only.background = scene.background;
    only.maxRecursion = scene.maxRecursion;
    only.gamma = scene.gamma;
    return linesOf(only, {"image_resolution", "background_colour", "max_recurse_level", "gamma_"});
}

std::string text(const Camera& camera) {
    Scene only;
    only.camera = camera;
    return linesOf(only, {"camera_", "focus_point", "up_vector"});
}

std::string text(const Light& light) {
    Scene only;
    only.lights = {light};
    return linesOf(only, {"light_source"});
}

std::string text(const Material& material) {
    Scene only;
    only.materials = {material};
    return linesOf(only, {"material", "tint"});
}

std::string text(const Body& body) {
    Scene only;
    only.materials = {{}};
    only.meshes = {standIn()};
    only.bodies = {body};
    only.bodies[0].material = {};
    if (auto* mesh = std::get_if<Mesh>(&only.bodies[0].shape)) mesh->mesh = {};
    const std::string all = printScene(only);
    return all.substr(all.find('\n', all.find("\nmaterial ") + 1) + 1);
}

std::optional<Scene> sceneOf(const std::string& lines, std::string& why) {
    std::string whole;
    const bool hasCamera = lines.find("camera_position") != lines.npos;
    if (!hasCamera) whole = "camera_position 0 0 1\nfocus_point 0 0 0\n";
    const bool isMaterial = lines.starts_with("material");
    if (!isMaterial && !hasCamera) whole += text(Material{});
    whole += lines;

    Sources sources;
    Diagnostics diagnostics;
    const MeshData mesh = standIn();
    std::optional<Scene> scene = parseScene(sources.add("extras", std::move(whole)), {},
                                            {{}, {}, std::span(&mesh, 1)}, sources, diagnostics);
    if (!scene) why = firstError(diagnostics);
    return scene;
}

std::string meshText(const MeshData& mesh) { return printPmf(mesh); }

std::optional<MeshData> meshOf(const std::string& pmf, std::string& why) {
    Sources sources;
    Diagnostics diagnostics;
    std::optional<MeshData> mesh = parsePmf(sources.add("extras", pmf), sources, diagnostics);
    if (!mesh) why = firstError(diagnostics);
    return mesh;
}

} // namespace yarte::convert::gltf
