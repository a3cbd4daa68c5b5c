#include "convert/povray/mesh.h"

#include "convert/povray/eye.h"
#include "convert/povray/sdl_text.h"
#include "yarte/base/number.h"
#include "yarte/scene/mesh_placement.h"
#include "yarte/scene/referential.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace yarte::convert::povray {
namespace {

std::string vectorArray(const std::string& name, const std::vector<Vec3>& values) {
    std::string text = fmt::format("#declare {} = array[{}] {{\n", name, values.size());
    for (const Vec3 v : values) text += fmt::format("    {},\n", sdl(v));
    text.erase(text.size() - 2, 1); // no comma after the last
    return text + "}\n";
}

template <typename FaceText>
std::string faceArray(const std::string& name, const MeshData& mesh, std::size_t size,
                      const FaceText& faceText) {
    std::string text = fmt::format("#declare {} = array[{}] {{\n", name, size);
    for (std::size_t f = 0; f < mesh.faceCount(); ++f) text += fmt::format("    {},\n", faceText(f));
    text.erase(text.size() - 2, 1);
    return text + "}\n";
}

std::string indices(std::span<const std::uint32_t> values) {
    std::string text;
    for (const std::uint32_t i : values)
        fmt::format_to(std::back_inserter(text), "{}{}", text.empty() ? "" : ", ", i);
    return text;
}

bool isFloat(double v) { return static_cast<double>(static_cast<float>(v)) == v; }
bool isFloat(Vec3 v) { return isFloat(v.x) && isFloat(v.y) && isFloat(v.z); }

bool isTriangulated(const MeshData& mesh) { return mesh.corners.size() == 3 * mesh.faceCount(); }

std::string arrays(const std::string& name, const MeshData& mesh) {
    std::string text = vectorArray(name + "_Vertices", mesh.vertices);
    text += faceArray(name + "_Faces", mesh, mesh.corners.size() + mesh.faceCount(), [&](std::size_t f) {
        return fmt::format("{}, {}", mesh.face(f).size(), indices(mesh.face(f)));
    });
    if (!mesh.isSmooth()) return text;
    text += vectorArray(name + "_Normals", mesh.normals);
    return text + faceArray(name + "_Face_Normals", mesh, mesh.cornerNormals.size(),
                            [&](std::size_t f) { return indices(mesh.faceNormals(f)); });
}

/// "    NAME { COUNT, ... }", each line made by `line` from its index.
template <typename Line>
std::string list(const char* name, std::size_t count, const Line& line) {
    std::string text = fmt::format("    {} {{\n        {}", name, count);
    for (std::size_t i = 0; i < count; ++i) text += ",\n        " + line(i);
    return text + "\n    }\n";
}

/// The front of a POV-Ray triangle is by the left-hand rule.
std::string leftHanded(std::span<const std::uint32_t> triangle) {
    return fmt::format("<{}, {}, {}>", triangle[0], triangle[2], triangle[1]);
}

std::string mesh2(const std::string& name, const MeshData& mesh) {
    std::string text = fmt::format("#declare {} = mesh2 {{\n", name);
    text +=
        list("vertex_vectors", mesh.vertices.size(), [&](std::size_t i) { return sdl(mesh.vertices[i]); });
    if (mesh.isSmooth())
        text +=
            list("normal_vectors", mesh.normals.size(), [&](std::size_t i) { return sdl(mesh.normals[i]); });
    text += list("face_indices", mesh.faceCount(), [&](std::size_t f) { return leftHanded(mesh.face(f)); });
    if (mesh.isSmooth())
        text += list("normal_indices", mesh.faceCount(),
                     [&](std::size_t f) { return leftHanded(mesh.faceNormals(f)); });
    // The camera may be inside. Which vector does not matter: this one is parallel to few edges.
    return text + (isClosed(mesh) ? "    inside_vector <0.31, 0.52, 0.79>\n" : "") + "}\n";
}

} // namespace

std::string meshDeclarations(const Scene& scene, bool plain) {
    std::string text;
    for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
        const MeshData& mesh = scene.meshes[i];
        const std::string name = fmt::format("Mesh_{}", i + 1);
        text += fmt::format("\n#declare {}_File = {}\n", name, stringLiteral(mesh.path));
        text += plain && isTriangulated(mesh) ? mesh2(name, mesh) : arrays(name, mesh);
    }
    return text;
}

bool isRounded(const MeshData& mesh, bool plain) {
    return plain && isTriangulated(mesh) &&
           !std::ranges::all_of(mesh.vertices, [](Vec3 v) { return isFloat(v); });
}

std::string meshObject(const Scene& scene, const Body& body, const Mesh& mesh, bool plain) {
    const MeshData& data = scene.meshes[mesh.mesh.index];
    const std::string name = fmt::format("Mesh_{}", mesh.mesh.index + 1);
    const std::string scale = printNumber(mesh.scale), axes = sdl(resolveReferential(mesh.axes)),
                      translation = sdl(mesh.translation);
    if (plain && isTriangulated(data))
        return fmt::format(
            "object {{\n    {}\n    scale {}\n    Yarte_Turn({})\n    translate {}\n    scale World_Scale\n",
            name, scale, axes, translation);

    const bool isTransmissive = transmits(scene.materials[body.material.index]);
    const Vec3 eye = scene.camera.position;
    const bool holdsEye = isTransmissive && isInside(data, placedVertices(data, mesh), eye);
    // A union, as POV-Ray's meshes keep their planes in float32; it warns of a union of one.
    std::string text = data.faceCount() == 1 && !holdsEye ? "object {\n" : "union {\n";
    text += data.isSmooth()
                ? fmt::format(
                      "    Yarte_Smooth_Faces({0}_Vertices, {0}_Faces, {0}_Normals, {0}_Face_Normals, ", name)
                : fmt::format("    Yarte_Faces({0}_Vertices, {0}_Faces, ", name);
    text += fmt::format("{}, {}, {})\n", scale, axes, translation);
    if (holdsEye) text += fmt::format("    Yarte_Inside({})\n", sdl(eye));
    return text;
}

} // namespace yarte::convert::povray
