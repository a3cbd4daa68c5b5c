#include "convert/gltf/primitive.h"

#include "convert/gltf/accessor.h"
#include "yarte/base/huge_pages.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace yarte::convert::gltf {
namespace {

using Indices = std::vector<std::uint32_t>;

/// The corners of a strip's or fan's triangles (glTF 2.0 section 3.7.2.1); those of separate triangles are
/// `vertices` themselves. What is left over is no triangle.
Indices triangleCorners(Mode mode, Indices vertices) {
    if (mode == Mode::triangles) {
        vertices.resize(vertices.size() / 3 * 3);
        return vertices;
    }
    Indices corners;
    if (vertices.size() < 3) return corners;
    reserveWhole(corners, 3 * (vertices.size() - 2));
    for (std::size_t i = 0; i + 2 < vertices.size(); ++i) {
        const std::size_t odd = i % 2;
        if (mode == Mode::triangleStrip)
            corners.insert(corners.end(), {vertices[i], vertices[i + 1 + odd], vertices[i + 2 - odd]});
        else
            corners.insert(corners.end(), {vertices[i + 1], vertices[i + 2], vertices[0]});
    }
    return corners;
}

/// base + sum of weight * delta.
bool addTargets(Content& content, const Primitive& primitive, const std::vector<double>& weights,
                std::optional<AccessorId> MorphTarget::*which, std::vector<Vec3>& base) {
    const std::size_t count = std::min(weights.size(), primitive.targets.size());
    for (std::size_t t = 0; t < count; ++t) {
        const std::optional<AccessorId> id = primitive.targets[t].*which;
        if (!id || weights[t] == 0) continue;
        const auto deltas = readVectors(content, *id);
        if (!deltas) return false;
        for (std::size_t i = 0; i < base.size(); ++i) base[i] += (*deltas)[i] * weights[t];
    }
    return true;
}

void add(Transform& sum, const Transform& m, double weight) {
    sum.x += m.x * weight, sum.y += m.y * weight, sum.z += m.z * weight;
    sum.translation += m.translation * weight;
}

/// Unit length; 0 stays 0.
void normalise(std::vector<Vec3>& vectors) {
    for (Vec3& v : vectors) {
        const double size = length(v);
        if (size > 0) v = v / size;
    }
}

/// Linear blend skinning (glTF 2.0 section 3.7.3.3); weights are made to sum to 1, as quantised ones do not.
bool skin(Content& content, const Primitive& primitive, const std::vector<Transform>& joints,
          MeshData& mesh) {
    constexpr Transform zero{{}, {}, {}, {}};
    std::vector<Transform> blended(mesh.vertices.size(), zero);
    std::vector<double> sums(mesh.vertices.size());
    for (std::size_t set = 0; set < primitive.joints.size(); ++set) {
        const auto ids = readNumbers(content, primitive.joints[set]),
                   weights = readNumbers(content, primitive.weights[set]);
        if (!ids || !weights) return false;
        for (std::size_t i = 0; i < ids->size(); ++i) {
            const double weight = (*weights)[i], joint = (*ids)[i];
            if (weight == 0) continue;
            if (!(joint >= 0 && joint < static_cast<double>(joints.size()))) {
                content.errors().report("gltf.bad-reference", "names a joint that the skin does not have",
                                        *content.document().accessors[primitive.joints[set]].json);
                return false;
            }
            add(blended[i / 4], joints[static_cast<std::size_t>(joint)], weight);
            sums[i / 4] += weight;
        }
    }
    for (std::size_t i = 0; i < blended.size(); ++i) {
        if (sums[i] == 0) continue; // belongs to no joint: stays
        Transform m = zero;
        add(m, blended[i], 1 / sums[i]);
        mesh.vertices[i] = m.point(mesh.vertices[i]);
        if (!mesh.normals.empty()) mesh.normals[i] = normalTransform(m).direction(mesh.normals[i]);
    }
    normalise(mesh.normals);
    return true;
}

Vec3 faceNormal(const MeshData& mesh, std::span<const std::uint32_t> face) {
    const Vec3 a = mesh.vertices[face[0]];
    return cross(mesh.vertices[face[1]] - a, mesh.vertices[face[2]] - a);
}

void replaceZeroNormals(MeshData& mesh) {
    const auto isZero = [](Vec3 n) { return n == Vec3{}; };
    if (std::ranges::none_of(mesh.normals, isZero)) return;
    std::vector<Vec3> sums(mesh.normals.size());
    for (std::size_t f = 0; f < mesh.faceCount(); ++f)
        for (const std::uint32_t corner : mesh.face(f)) sums[corner] += faceNormal(mesh, mesh.face(f));
    normalise(sums);
    for (std::size_t i = 0; i < sums.size(); ++i)
        if (isZero(mesh.normals[i])) mesh.normals[i] = isZero(sums[i]) ? Vec3{0, 1, 0} : sums[i];
}

} // namespace

std::optional<MeshData> readPrimitive(Content& content, const Primitive& primitive, const Pose& pose) {
    MeshData mesh;
    auto vertices = readVectors(content, *primitive.position);
    if (!vertices) return std::nullopt;
    mesh.vertices = std::move(*vertices);
    if (primitive.normal) {
        auto normals = readVectors(content, *primitive.normal);
        if (!normals) return std::nullopt;
        mesh.normals = std::move(*normals);
    }
    if (!addTargets(content, primitive, pose.weights, &MorphTarget::position, mesh.vertices))
        return std::nullopt;
    if (!mesh.normals.empty() &&
        !addTargets(content, primitive, pose.weights, &MorphTarget::normal, mesh.normals))
        return std::nullopt;
    if (!pose.joints.empty() && !skin(content, primitive, pose.joints, mesh)) return std::nullopt;

    Indices order(primitive.indices ? 0 : mesh.vertices.size());
    if (primitive.indices) {
        auto indices = readIndices(content, *primitive.indices, mesh.vertices.size());
        if (!indices) return std::nullopt;
        order = std::move(*indices);
    } else {
        std::iota(order.begin(), order.end(), 0U);
    }
    mesh.corners = triangleCorners(primitive.mode, std::move(order));
    const std::size_t faceCount = mesh.corners.size() / 3;
    reserveWhole(mesh.faceStarts, faceCount + 1);
    for (std::size_t f = 1; f <= faceCount; ++f) mesh.faceStarts.push_back(static_cast<std::uint32_t>(3 * f));
    if (mesh.normals.empty()) return mesh;
    replaceZeroNormals(mesh);
    reserveWhole(mesh.cornerNormals, mesh.corners.size());
    mesh.cornerNormals = mesh.corners;
    return mesh;
}

void transform(MeshData& mesh, const Transform& m) {
    if (m == Transform{}) return;
    for (Vec3& v : mesh.vertices) v = m.point(v);
    const Transform turned = normalTransform(m);
    for (Vec3& n : mesh.normals) n = turned.direction(n);
    normalise(mesh.normals);
    if (mesh.isSmooth()) replaceZeroNormals(mesh);
    if (m.determinant() >= 0) return;
    for (std::vector<std::uint32_t>* corners : {&mesh.corners, &mesh.cornerNormals})
        for (std::size_t c = 0; c + 2 < corners->size(); c += 3)
            std::swap((*corners)[c + 1], (*corners)[c + 2]);
}

} // namespace yarte::convert::gltf
