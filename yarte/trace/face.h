// Face: a filled polygon over shared vertices: a polygon of the scene, or one face of a mesh.
//
// Whether a ray passes inside is decided on the vertices as the ray sees them: sheared so that the ray is the
// z axis [Woop, Benthin, Wald, "Watertight Ray/Triangle Intersection", JCGT 2013], then even-odd counting of
// the edges that cross the +x half-axis, each by the exact sign of a 2x2 determinant. A vertex shared by
// faces has one image and an edge one answer, whichever face asks: neighbouring faces neither leak nor both
// count. The distance comes from the plane (decision D9). A ray that starts in that plane has nothing of the
// face ahead of it: it left one neighbour at their common edge, and rounding may put it on either side of the
// other.
#pragma once

#include "yarte/trace/bounds.h"
#include "yarte/trace/ray.h"

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

namespace yarte::trace {

/// The plane of a face (decision D9).
struct FacePlane {
    Vec3 normal; ///< unit, Newell's rule
    Vec3 anchor; ///< the vertices' mean; of a triangle, whose vertices all lie in the plane, the first one
};

inline Vec3 triangleNormal(Vec3 a, Vec3 b, Vec3 c) { return normalised(cross(b - a, c - a)); }

struct Face {
    static constexpr std::uint32_t noPlane = 0xffffffff;
    std::uint32_t firstCorner = 0, cornerCount = 0;
    std::uint32_t plane = noPlane; ///< in FaceTable::planes, for more than three corners
    bool isSmooth = false;
};

struct FaceTable {
    std::vector<Vec3> vertices;
    std::vector<std::uint32_t> corners;       ///< vertex indices, face after face
    std::vector<Vec3> normals;                ///< unit vertex normals of smooth faces
    std::vector<std::uint32_t> cornerNormals; ///< parallel to corners, or empty if nothing is smooth
    std::vector<Face> faces;
    /// Of larger polygons. A triangle's plane is computed when a ray passes inside, which is rare, and not
    /// kept: millions of them are more often looked at than met.
    std::vector<FacePlane> planes;
    /// A start so near to a plane lies in it, as far as its rounded coordinates tell.
    double rounding = 0;

    std::span<const std::uint32_t> cornersOf(const Face& f) const {
        return std::span(corners).subspan(f.firstCorner, f.cornerCount);
    }
};

/// A face as the other shapes are: a value that can be asked.
struct FaceShape {
    static constexpr bool isFlat = true, isClosed = false;
    const FaceTable& table;
    const Face& face;
};

/// A vertex as the ray sees it: the ray is the z axis through (0, 0).
struct Seen {
    double x, y;
};

/// Shears space so that `direction` becomes the z axis.
class Shear {
public:
    explicit Shear(const Ray& ray) : origin_(ray.origin) {
        const Vec3 d = ray.direction;
        const double ax = std::abs(d.x), ay = std::abs(d.y), az = std::abs(d.z);
        axis_ = ax > ay ? (ax > az ? 0 : 2) : (ay > az ? 1 : 2);
        const Vec3 p = rotated(d);
        slopeX_ = p.x / p.z, slopeY_ = p.y / p.z;
    }
    Seen operator()(Vec3 vertex) const {
        const Vec3 p = rotated(vertex - origin_);
        return {p.x - slopeX_ * p.z, p.y - slopeY_ * p.z};
    }

private:
    /// Cyclic, so that the largest component of the direction comes last.
    Vec3 rotated(Vec3 v) const {
        return axis_ == 0 ? Vec3{v.y, v.z, v.x} : axis_ == 1 ? Vec3{v.z, v.x, v.y} : v;
    }
    Vec3 origin_;
    int axis_ = 2;
    double slopeX_ = 0, slopeY_ = 0;
};

/// Exact sign (-1, 0, 1) of a.x b.y - b.x a.y, barring underflow: rounding keeps the order of two products,
/// and if they round to the same number their rounding errors decide.
inline int orientation(Seen a, Seen b) {
    const double left = a.x * b.y, right = b.x * a.y;
    if (left != right) return left > right ? 1 : -1;
    const double leftError = std::fma(a.x, b.y, -left), rightError = std::fma(b.x, a.y, -right);
    return leftError > rightError ? 1 : leftError < rightError ? -1 : 0;
}

/// True if the edge from a to b crosses the half-axis y = 0, x > 0. Symmetric in a and b.
inline bool crossesHalfAxis(Seen a, Seen b) {
    const bool aAbove = a.y > 0, bAbove = b.y > 0;
    if (aAbove == bAbove) return false;
    return orientation(a, b) == (bAbove ? 1 : -1);
}

inline Bounds bounds(const FaceShape& s) {
    Bounds result;
    for (const std::uint32_t vertex : s.table.cornersOf(s.face)) result.add(s.table.vertices[vertex]);
    return result;
}

/// From the vertices.
FacePlane computePlane(const FaceTable&, const Face&);

inline FacePlane planeOf(const FaceTable& table, const Face& face) {
    return face.plane != Face::noPlane ? table.planes[face.plane] : computePlane(table, face);
}

inline Crossings crossings(const FaceShape& s, const Ray& ray) {
    Crossings result;
    const Shear shear(ray);
    const auto corners = s.table.cornersOf(s.face);
    bool isInside = false;
    Seen previous = shear(s.table.vertices[corners.back()]);
    for (const std::uint32_t vertex : corners) {
        const Seen next = shear(s.table.vertices[vertex]);
        if (crossesHalfAxis(previous, next)) isInside = !isInside;
        previous = next;
    }
    if (!isInside) return result;
    const FacePlane plane = planeOf(s.table, s.face);
    const double fall = -dot(ray.direction, plane.normal);
    const double height = dot(ray.origin - plane.anchor, plane.normal);
    if (fall != 0 && std::abs(height) > s.table.rounding) result.add(height / fall, 0, fall > 0);
    return result;
}

/// The plane's normal or, on a smooth face, the interpolated one: barycentric in the projection along the
/// plane normal's largest component.
Vec3 outwardNormal(const FaceShape&, Vec3 point, std::uint8_t part);

} // namespace yarte::trace
