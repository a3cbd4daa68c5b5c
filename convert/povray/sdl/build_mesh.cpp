#include "convert/povray/sdl/build_mesh.h"

#include "convert/povray/sdl/stretch.h"
#include "yarte/base/huge_pages.h"

#include <algorithm>
#include <functional>
#include <utility>

namespace yarte::convert::povray::sdl {
namespace {

using Indices = MeshShape::Indices;

/// POV-Ray's normals are of unit length; one of length 0 in a mesh2 is <1, 0, 0> there.
Vec3 unitNormal(Vec3 n) { return n == Vec3{} ? Vec3{1, 0, 0} : unit(n); }

bool hasArea(Vec3 a, Vec3 b, Vec3 c) { return cross(b - a, c - a) != Vec3{}; }

/// The faces of one texture, with their vertices and normals and no others, and the front of YARTE's.
class Extraction {
public:
    Extraction(const MeshShape& mesh, std::uint32_t texture, bool swaps) : mesh_(mesh), swaps_(swaps) {
        const bool takesAll = mesh.faceTextures.empty();
        const auto isTaken = [&](std::size_t f) { return takesAll || mesh.faceTextures[f] == texture; };
        const auto count = takesAll
                               ? mesh.faces.size()
                               : static_cast<std::size_t>(std::ranges::count(mesh.faceTextures, texture));
        isSmooth_ = !mesh.faceNormals.empty();
        reserveWhole(data_.corners, 3 * count), reserveWhole(data_.faceStarts, count + 1);
        if (isSmooth_) reserveWhole(data_.cornerNormals, 3 * count);
        for (std::size_t f = 0; f < mesh.faces.size(); ++f)
            if (isTaken(f)) add(f);
        data_.vertices = chosen(mesh.vertices, data_.corners, takesAll);
        if (isSmooth_) {
            data_.normals = chosen(mesh.normals, data_.cornerNormals, takesAll);
            for (Vec3& n : data_.normals) n = unitNormal(n);
        }
    }

    std::size_t flat() const { return flat_; }
    MeshData take() && { return std::move(data_); }

private:
    void add(std::size_t f) {
        const auto& [a, b, c] = mesh_.faces[f];
        if (!hasArea(mesh_.vertices[a], mesh_.vertices[b], mesh_.vertices[c])) {
            ++flat_;
            return;
        }
        append(data_.corners, mesh_.faces[f]);
        if (isSmooth_) append(data_.cornerNormals, mesh_.faceNormals[f]);
        data_.faceStarts.push_back(static_cast<std::uint32_t>(data_.corners.size()));
    }

    void append(std::vector<std::uint32_t>& to, const Indices& face) const {
        to.push_back(face[0]), to.push_back(face[swaps_ ? 2 : 1]), to.push_back(face[swaps_ ? 1 : 2]);
    }

    /// All of them, or those that `indices` name, which then name them in the result.
    static std::vector<Vec3> chosen(const std::vector<Vec3>& from, std::vector<std::uint32_t>& indices,
                                    bool all) {
        std::vector<Vec3> result;
        if (all) {
            reserveWhole(result, from.size());
            result = from;
            return result;
        }
        std::vector<std::uint32_t> places(from.size(), MeshShape::none);
        for (std::uint32_t& i : indices) {
            if (places[i] == MeshShape::none) {
                places[i] = static_cast<std::uint32_t>(result.size());
                result.push_back(from[i]);
            }
            i = places[i];
        }
        return result;
    }

    const MeshShape& mesh_;
    bool swaps_, isSmooth_ = false;
    std::size_t flat_ = 0;
    MeshData data_;
};

/// Right-handed axes for a mesh whose z has changed its sign.
Mesh placement(MeshId id, const Affine& a, double scale, bool isMirrored) {
    const Vec3 z = isMirrored ? -a.z : a.z;
    return {id, scale, {a.x / scale, a.y / scale, z / scale}, a.t};
}

} // namespace

std::optional<Mesh> Meshes::place(const std::shared_ptr<const MeshShape>& mesh, std::uint32_t texture,
                                  const Affine& a, std::size_t& flat) {
    const bool isMirrored = determinant(a) < 0;
    const Similarity similarity = similarityOf(a);
    if (similarity.error > rounding) {
        Extraction extraction(*mesh, texture, !isMirrored);
        flat += extraction.flat();
        MeshData data = std::move(extraction).take();
        if (data.faceCount() == 0) return std::nullopt;
        for (Vec3& v : data.vertices) v = mapPoint(a, v);
        for (Vec3& n : data.normals) n = unitNormal(mapNormal(a, n));
        return add(std::move(data));
    }
    Kept& kept = kept_[{mesh.get(), texture, isMirrored}];
    if (!kept.alive) {
        kept.alive = mesh;
        Extraction extraction(*mesh, texture, !isMirrored);
        kept.flat = extraction.flat();
        MeshData data = std::move(extraction).take();
        if (isMirrored) {
            for (Vec3& v : data.vertices) v.z = -v.z;
            for (Vec3& n : data.normals) n.z = -n.z;
        }
        if (data.faceCount() > 0) kept.id = add(std::move(data)).mesh;
    }
    flat += kept.flat;
    if (!kept.id) return std::nullopt;
    return placement(*kept.id, a, similarity.scale, isMirrored);
}

Mesh Meshes::add(MeshData data) {
    all_.push_back(std::move(data));
    return {{static_cast<std::uint32_t>(all_.size() - 1)}, 1, {{1, 0, 0}, {0, 1, 0}, Vec3{0, 0, 1}}, {}};
}

std::size_t TriangleRun::Bits::operator()(Vec3 v) const {
    const std::hash<double> hash;
    return (hash(v.x) * 31 + hash(v.y)) * 1099511628211U + hash(v.z) * 0x9e3779b97f4a7c15U;
}

std::uint32_t TriangleRun::vertex(Vec3 v) {
    const auto [entry, isNew] = vertices_.try_emplace(v, static_cast<std::uint32_t>(data_.vertices.size()));
    if (isNew) data_.vertices.push_back(v);
    return entry->second;
}

std::uint32_t TriangleRun::normal(Vec3 n) {
    const auto [entry, isNew] = normals_.try_emplace(n, static_cast<std::uint32_t>(data_.normals.size()));
    if (isNew) data_.normals.push_back(n);
    return entry->second;
}

/// Flat triangles among smooth ones have three equal normals.
void TriangleRun::makeSmooth() {
    for (std::size_t f = 0; f < data_.faceCount(); ++f) {
        const auto face = data_.face(f);
        const Vec3 a = data_.vertices[face[0]], b = data_.vertices[face[1]], c = data_.vertices[face[2]];
        data_.cornerNormals.insert(data_.cornerNormals.end(), 3, normal(unit(cross(b - a, c - a))));
    }
}

bool TriangleRun::add(const TriangleShape& triangle, const Affine& a) {
    const auto& [p, q, r] = triangle.corners;
    if (!hasArea(p, q, r)) return false;
    if (triangle.normals && std::ranges::count(*triangle.normals, Vec3{}) > 0) return false;
    const bool swaps = !(determinant(a) < 0);
    const std::array<std::size_t, 3> order{0, swaps ? 2U : 1U, swaps ? 1U : 2U};
    std::array<Vec3, 3> corners;
    for (std::size_t i = 0; i < 3; ++i) corners[i] = mapPoint(a, triangle.corners[order[i]]);
    const Vec3 across = cross(corners[1] - corners[0], corners[2] - corners[0]);
    if (across == Vec3{}) return false;
    if (triangle.normals && data_.normals.empty()) makeSmooth();
    for (const Vec3 corner : corners) data_.corners.push_back(vertex(corner));
    data_.faceStarts.push_back(static_cast<std::uint32_t>(data_.corners.size()));
    if (triangle.normals)
        for (const std::size_t i : order)
            data_.cornerNormals.push_back(normal(unitNormal(mapNormal(a, (*triangle.normals)[i]))));
    else if (!data_.normals.empty())
        data_.cornerNormals.insert(data_.cornerNormals.end(), 3, normal(unit(across)));
    return true;
}

MeshData TriangleRun::take() {
    vertices_.clear(), normals_.clear();
    return std::exchange(data_, {});
}

} // namespace yarte::convert::povray::sdl
