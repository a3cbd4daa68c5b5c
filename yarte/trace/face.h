// Face: a filled polygon over shared vertices: a polygon of the scene, or one face of a mesh.
//
// Whether a ray passes inside is decided on the vertices as the ray sees them: sheared so that the ray is the
// z axis [Woop, Benthin, Wald, "Watertight Ray/Triangle Intersection", JCGT 2013], then even-odd counting of
// the edges that cross the +x half-axis, each by the sign of a 2x2 determinant, which is certain or computed
// in twice the precision. A vertex shared by faces has one image and an edge one answer, whichever face asks:
// neighbouring faces neither leak nor both count. The distance comes from the plane (decision D9). A ray that
// left a surface and starts in that plane has nothing of the face ahead of it: it left one neighbour at their
// common edge, and rounding may put it on either side of the other.
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

/// Of triangles whose first angle has a sine whose square is below this, the plain cross product cancels.
inline constexpr double maxSliver = 0x1p-4;

/// A sliver's cross product, rounded, would be turned about one of the corners, and miss the others by more
/// than their rounding. There each component, a difference of products, is computed to 1.5 ulps [Jeannerod,
/// Louvet, Muller, "Further analysis of Kahan's algorithm for the accurate computation of 2x2 determinants",
/// Math. Comp. 2013].
inline Vec3 triangleNormal(Vec3 a, Vec3 b, Vec3 c) {
    const Vec3 u = b - a, v = c - a, plain = cross(u, v);
    if (dot(plain, plain) >= maxSliver * (dot(u, u) * dot(v, v))) return normalised(plain);
    const auto determinant = [](double p, double q, double r, double s) { // p q - r s
        const double rs = r * s;
        return std::fma(p, q, -rs) - std::fma(r, s, -rs);
    };
    return normalised(
        {determinant(u.y, v.z, u.z, v.y), determinant(u.z, v.x, u.x, v.z), determinant(u.x, v.y, u.y, v.x)});
}

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
    /// A point of a surface that is so near to a plane lies in it, as far as its rounded coordinates tell.
    double rounding = 0;
    double largest = Bounds::infinity; ///< no vertex has a larger coordinate

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

/// A vertex as the ray sees it: the ray is the z axis through (0, 0). z is not foreshortened: of the vertex
/// itself.
struct Seen {
    double x, y, z;
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
        return {p.x - slopeX_ * p.z, p.y - slopeY_ * p.z, p.z};
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

inline constexpr double edgeBlur = 0x1p-47; ///< see EdgeCount

/// Counts the edges of a face that cross the half-axis y = 0, x > 0, and knows how near to it all were.
///
/// Of a vertex at depth z x and y are good to 4 * 2^-53 (|z| + |x|), so a determinant of two is good to 2^-48
/// of the largest coordinate times the largest x or y. On which side of y = 0 a vertex is put matters for
/// edges that pass nearer than that only: one that is put wrongly takes both its edges with it.
class EdgeCount {
public:
    void add(Seen a, Seen b) {
        const double determinant = a.x * b.y - b.x * a.y;
        const bool aAbove = a.y > 0, bAbove = b.y > 0;
        if (aAbove != bAbove && (bAbove ? determinant > 0 : determinant < 0)) isInside_ = !isInside_;
        nearest_ = std::min(nearest_, std::abs(determinant));
        across_ = std::max(across_, std::max(std::abs(b.x), std::abs(b.y)));
        depth_ = std::max(depth_, std::abs(b.z));
    }
    bool isInside() const { return isInside_; }
    bool isDoubtful() const { return nearest_ <= edgeBlur * across_ * std::max(across_, depth_); }

private:
    bool isInside_ = false;
    double nearest_ = Bounds::infinity, across_ = 0, depth_ = 0;
};

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

/// Where the plane is nearly seen edge-on, or the start is next to it, rounding may decide.
inline Crossings quickCrossings(const FaceShape& s, const Ray& ray) {
    Crossings result;
    const Shear shear(ray);
    const auto corners = s.table.cornersOf(s.face);
    EdgeCount edges;
    Seen previous = shear(s.table.vertices[corners.back()]);
    for (const std::uint32_t vertex : corners) {
        const Seen next = shear(s.table.vertices[vertex]);
        edges.add(previous, next);
        previous = next;
    }
    result.isDoubtful = edges.isDoubtful();
    if (!edges.isInside()) return result;
    const FacePlane plane = planeOf(s.table, s.face);
    const Vec3 fromAnchor = ray.origin - plane.anchor;
    const double fall = -dot(ray.direction, plane.normal), height = dot(fromAnchor, plane.normal);
    const double far = std::abs(fromAnchor.x) + std::abs(fromAnchor.y) + std::abs(fromAnchor.z);
    const bool isOff = ray.from.element == ElementId{} || std::abs(height) > s.table.rounding;
    result.isDoubtful |= isOff && (std::abs(fall) <= 0x1p-20 || std::abs(height) <= 0x1p-16 * far);
    if (fall != 0 && isOff) result.add(height / fall, 0, fall > 0);
    return result;
}

/// Of a face with these corners, into `vertices`; `rounding` is that of FaceTable.
Crossings carefulCrossings(std::span<const std::uint32_t> corners, const Vec3* vertices, double rounding,
                           const Ray&);

inline Crossings carefulCrossings(const FaceShape& s, const Ray& ray) {
    return carefulCrossings(s.table.cornersOf(s.face), s.table.vertices.data(), s.table.rounding, ray);
}

/// The plane's normal or, on a smooth face, the interpolated one: barycentric in the projection along the
/// plane normal's largest component.
Vec3 outwardNormal(const FaceShape&, Vec3 point, std::uint8_t part);

} // namespace yarte::trace
