#include "yarte/base/number.h"
#include "yarte/lang/pmf.h"

namespace yarte {
namespace {

void print(std::string& text, const std::vector<Vec3>& vectors) {
    for (const Vec3 v : vectors)
        text.append(printNumber(v.x))
            .append(" ")
            .append(printNumber(v.y))
            .append(" ")
            .append(printNumber(v.z)) += '\n';
}

void print(std::string& text, std::span<const std::uint32_t> indices) {
    const char* separator = "";
    for (const std::uint32_t index : indices)
        text.append(separator).append(std::to_string(index)), separator = " ";
    text += '\n';
}

} // namespace

std::string printPmf(const MeshData& mesh) {
    std::string text = std::to_string(mesh.vertices.size()) + ' ' + std::to_string(mesh.faceCount()) + '\n';
    print(text, mesh.vertices);
    for (std::size_t f = 0; f < mesh.faceCount(); ++f) print(text, mesh.face(f));
    if (!mesh.isSmooth()) return text;
    text += "normals " + std::to_string(mesh.normals.size()) + '\n';
    print(text, mesh.normals);
    text += "face_normals\n";
    for (std::size_t f = 0; f < mesh.faceCount(); ++f) print(text, mesh.faceNormals(f));
    return text;
}

} // namespace yarte
