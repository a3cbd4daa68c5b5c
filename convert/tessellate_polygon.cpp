#include "convert/tessellate_polygon.h"

#include "convert/tessellate_outline.h"
#include "yarte/base/huge_pages.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

namespace yarte::convert {
namespace {

/// Newell's, of any length; in units of the largest distance from the first vertex, so that nothing
/// overflows.
Vec3 newell(std::span<const Vec3> outline) {
    double unit = 0;
    for (const Vec3 v : outline) {
        const Vec3 d = v - outline[0];
        unit = std::max({unit, std::abs(d.x), std::abs(d.y), std::abs(d.z)});
    }
    Vec3 normal;
    if (unit == 0) return normal;
    for (std::size_t i = 1; i + 1 < outline.size(); ++i)
        normal += cross((outline[i] - outline[0]) / unit, (outline[i + 1] - outline[0]) / unit);
    return normal;
}

/// Seen from the front, along the axis nearest to the normal: what is left are the vertices' own coordinates.
std::vector<Point2> flattened(std::span<const Vec3> outline) {
    const Vec3 n = newell(outline), size{std::abs(n.x), std::abs(n.y), std::abs(n.z)};
    const bool alongX = size.x >= size.y && size.x >= size.z, alongY = !alongX && size.y >= size.z;
    const double towards = alongX ? n.x : alongY ? n.y : n.z;
    std::vector<Point2> points;
    for (const Vec3 v : outline) {
        const Point2 p = alongX ? Point2{v.y, v.z} : alongY ? Point2{v.z, v.x} : Point2{v.x, v.y};
        points.push_back(towards < 0 ? Point2{p.v, p.u} : p);
    }
    return points;
}

/// Indices of trapezoids' corners: the outline's where they are its vertices.
class EdgePoints {
public:
    EdgePoints(std::span<const Vec3> outline, std::vector<Vec3>& added) : outline_(outline), added_(added) {}

    std::uint32_t indexOf(EdgePoint p) {
        const auto count = static_cast<std::uint32_t>(outline_.size());
        if (p.t == 0) return p.edge;
        if (p.t == 1) return (p.edge + 1) % count;
        const auto next = static_cast<std::uint32_t>(outline_.size() + added_.size());
        const auto [entry, isNew] = known_.try_emplace({p.edge, p.t}, next);
        if (isNew) {
            const Vec3 a = outline_[p.edge], b = outline_[(p.edge + 1) % count];
            added_.push_back(a + (b - a) * p.t);
        }
        return entry->second;
    }

private:
    std::span<const Vec3> outline_;
    std::vector<Vec3>& added_;
    std::map<std::pair<std::uint32_t, double>, std::uint32_t> known_;
};

bool sameBits(double a, double b) {
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

bool sameBits(const std::vector<Vec3f>& written, const std::vector<Vec3>& exact) {
    return std::ranges::equal(written, exact, [](const Vec3f& w, Vec3 e) {
        return sameBits(w[0], e.x) && sameBits(w[1], e.y) && sameBits(w[2], e.z);
    });
}

double roundingOf(const std::vector<Vec3f>& positions, std::span<const Vec3> exact) {
    double worst = 0;
    for (std::size_t i = 0; i < exact.size(); ++i)
        worst = std::max(worst, length(widened(positions[i]) - exact[i]));
    return worst;
}

/// glTF's and others' normals are unit; one that is so within what float32 can say stays as it is.
Vec3f unitNormal(Vec3 n) {
    const double size = length(n);
    if (std::abs(size - 1) < 1e-6) return rounded(n);
    return rounded(size > 0 && std::isfinite(size) ? n / size : Vec3{0, 1, 0});
}

/// Faces of a flat mesh over its own vertices.
void addFlatFaces(const MeshData& data, Tessellation& result) {
    std::vector<Vec3> outline;
    for (std::size_t f = 0; f < data.faceCount(); ++f) {
        const auto face = data.face(f);
        if (face.size() == 3) {
            result.triangles.push_back({face[0], face[1], face[2]});
            continue;
        }
        outline.clear();
        for (const std::uint32_t corner : face) outline.push_back(data.vertices[corner]);
        const Triangulation cut = triangulate(outline);
        const auto first = static_cast<std::uint32_t>(result.positions.size());
        for (const Vec3 v : cut.added) result.positions.push_back(rounded(v));
        for (auto triangle : cut.triangles) {
            for (std::uint32_t& i : triangle)
                i = i < face.size() ? face[i] : first + (i - static_cast<std::uint32_t>(face.size()));
            result.triangles.push_back(triangle);
        }
    }
}

/// One vertex for each pair of a vertex and a normal that occurs.
void addSmoothFaces(const MeshData& data, Tessellation& result) {
    const bool sameIndices =
        data.vertices.size() == data.normals.size() && data.corners == data.cornerNormals;
    reserveWhole(result.triangles, data.faceCount());
    if (sameIndices) {
        reserveWhole(result.positions, data.vertices.size()),
            reserveWhole(result.normals, data.normals.size());
        for (const Vec3 v : data.vertices) result.positions.push_back(rounded(v));
        for (const Vec3 n : data.normals) result.normals.push_back(unitNormal(n));
    }
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> known;
    const auto vertex = [&](std::size_t corner) {
        const std::pair pair{data.corners[corner], data.cornerNormals[corner]};
        if (sameIndices) return pair.first;
        const auto [entry, isNew] =
            known.try_emplace(pair, static_cast<std::uint32_t>(result.positions.size()));
        if (isNew) {
            result.positions.push_back(rounded(data.vertices[pair.first]));
            result.normals.push_back(unitNormal(data.normals[pair.second]));
        }
        return entry->second;
    };
    for (std::size_t c = 0; c + 2 < data.corners.size(); c += 3)
        result.triangles.push_back({vertex(c), vertex(c + 1), vertex(c + 2)});
}

} // namespace

Triangulation triangulate(std::span<const Vec3> outline) {
    Triangulation result;
    const std::vector<Point2> points = flattened(outline);
    if (isSimple(points)) {
        if (std::optional<Triangles> ears = clipEars(points)) {
            result.triangles = std::move(*ears);
            return result;
        }
    }
    EdgePoints indices(outline, result.added);
    for (const auto& [a, b, c] : cutIntoTrapezoids(points))
        result.triangles.push_back({indices.indexOf(a), indices.indexOf(b), indices.indexOf(c)});
    return result;
}

Tessellation tessellatePolygon(std::span<const Vec3> outline, Vec3 centre) {
    Triangulation cut = triangulate(outline);
    Tessellation result;
    result.triangles = std::move(cut.triangles);
    std::vector<Vec3> exact;
    for (const Vec3 v : outline) exact.push_back(v - centre);
    for (const Vec3 v : exact) result.positions.push_back(rounded(v));
    for (const Vec3 v : cut.added) result.positions.push_back(rounded(v - centre));
    result.deviation = roundingOf(result.positions, exact);
    if (result.triangles.empty()) result.triangles.push_back({0, 0, 0});
    return result;
}

Tessellation tessellateMesh(const MeshData& data) {
    Tessellation result;
    if (data.isSmooth()) {
        addSmoothFaces(data, result);
    } else {
        for (const Vec3 v : data.vertices) result.positions.push_back(rounded(v));
        addFlatFaces(data, result);
    }
    std::vector<Vec3f> all;
    reserveWhole(all, data.vertices.size());
    for (const Vec3 v : data.vertices) all.push_back(rounded(v));
    result.deviation = roundingOf(all, data.vertices);
    if (result.triangles.empty()) result.triangles.push_back({0, 0, 0});
    return result;
}

bool isSaidBy(const Tessellation& t, const MeshData& data) {
    if (3 * t.triangles.size() != data.corners.size() || data.corners.size() != 3 * data.faceCount())
        return false;
    for (std::size_t i = 0; i < t.triangles.size(); ++i)
        if (!std::ranges::equal(t.triangles[i], data.face(i))) return false;
    return sameBits(t.positions, data.vertices) && sameBits(t.normals, data.normals) &&
           (data.normals.empty() || data.corners == data.cornerNormals);
}

} // namespace yarte::convert
