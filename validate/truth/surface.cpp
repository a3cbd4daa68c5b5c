#include "validate/truth/surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <type_traits>
#include <variant>

namespace yarte::validate {

namespace {

/// Keeps the nearest of what is met in front of the ray.
class Nearest {
public:
    void add(const Real& distance, const RealVec3& normal) {
        if (distance > 0 && (!hit_ || distance < hit_->distance)) hit_ = SurfaceHit{distance, normal};
    }
    const std::optional<SurfaceHit>& hit() const { return hit_; }

private:
    std::optional<SurfaceHit> hit_;
};

/// The real roots of a t^2 + 2 b t + c.
std::vector<Real> roots(const Real& a, const Real& b, const Real& c) {
    if (a == 0) return b == 0 ? std::vector<Real>{} : std::vector<Real>{-c / (2 * b)};
    const Real discriminant = b * b - a * c;
    if (discriminant < 0) return {};
    const Real root = sqrt(discriminant);
    return {(-b - root) / a, (-b + root) / a};
}

std::optional<SurfaceHit> hitSphere(const RealRay& ray, const Real& radius) {
    Nearest nearest;
    for (const Real& t :
         roots(1, dot(ray.origin, ray.direction), dot(ray.origin, ray.origin) - radius * radius))
        nearest.add(t, ray.at(t) / radius);
    return nearest.hit();
}

std::optional<SurfaceHit> hitBox(const RealRay& ray, const RealVec3& sides) {
    using Component = Real RealVec3::*;
    constexpr std::array<Component, 3> axes{&RealVec3::x, &RealVec3::y, &RealVec3::z};
    Nearest nearest;
    for (std::size_t i = 0; i < 3; ++i) {
        const Component along = axes[i], u = axes[(i + 1) % 3], v = axes[(i + 2) % 3];
        if (ray.direction.*along == 0) continue;
        for (const int side : {-1, 1}) {
            const Real t = (side * sides.*along / 2 - ray.origin.*along) / ray.direction.*along;
            const RealVec3 p = ray.at(t);
            if (abs(p.*u) > sides.*u / 2 || abs(p.*v) > sides.*v / 2) continue;
            RealVec3 normal;
            normal.*along = side;
            nearest.add(t, normal);
        }
    }
    return nearest.hit();
}

/// The disc at the height `y`.
void addDisc(Nearest& nearest, const RealRay& ray, const Real& y, const Real& radius) {
    if (ray.direction.y == 0) return;
    const Real t = (y - ray.origin.y) / ray.direction.y;
    const RealVec3 p = ray.at(t);
    if (p.x * p.x + p.z * p.z <= radius * radius) nearest.add(t, {0, 1, 0});
}

/// Cones, frustums and cylinders: axis +y from the base at the origin.
struct Conical {
    Real base, top, height;
    bool hasBase, hasTop;
};

std::optional<SurfaceHit> hitConical(const RealRay& ray, const Conical& c) {
    const Real slope = (c.top - c.base) / c.height;
    const RealVec3 &o = ray.origin, &d = ray.direction;
    const Real radius = c.base + slope * o.y; // at the ray's origin
    Nearest nearest;
    for (const Real& t :
         roots(d.x * d.x + d.z * d.z - slope * slope * d.y * d.y,
               o.x * d.x + o.z * d.z - slope * d.y * radius, o.x * o.x + o.z * o.z - radius * radius)) {
        const RealVec3 p = ray.at(t);
        if (p.y < 0 || p.y > c.height) continue;
        nearest.add(t, normalised({p.x, -slope * (c.base + slope * p.y), p.z}));
    }
    if (c.hasBase) addDisc(nearest, ray, 0, c.base);
    if (c.hasTop) addDisc(nearest, ray, c.height, c.top);
    return nearest.hit();
}

/// The place of a shape's own axes, what is met there, and the ball around it in them.
struct Local {
    Vec3 centre;
    const ShapeSurface& surface;

    RealRay ray(const RealRay& world) const {
        const auto& axes = surface.axes;
        const RealVec3 o = world.origin - centre, &d = world.direction;
        return {{dot(o, axes[0]), dot(o, axes[1]), dot(o, axes[2])},
                {dot(d, axes[0]), dot(d, axes[1]), dot(d, axes[2])}};
    }
    std::optional<SurfaceHit> world(std::optional<SurfaceHit> hit) const {
        if (!hit) return hit;
        const auto& axes = surface.axes;
        const RealVec3 n = hit->normal;
        hit->normal = axes[0] * n.x + axes[1] * n.y + axes[2] * n.z;
        return hit;
    }
};

/// As the language defines the shapes that are Conical; nothing for others.
template <class S>
std::optional<Conical> conical(const S& s) {
    if constexpr (std::is_same_v<S, Cone>)
        return Conical{s.radius, 0, s.height, true, false};
    else if constexpr (std::is_same_v<S, TruncatedCone>)
        return Conical{s.radius, Real(s.radius) * (Real(s.coneHeight) - s.height) / s.coneHeight, s.height,
                       false, false};
    else if constexpr (std::is_same_v<S, Cylinder>)
        return Conical{s.radius, s.radius, s.height, true, true};
    else if constexpr (std::is_same_v<S, OpenCylinder>)
        return Conical{s.radius, s.radius, s.height, false, false};
    else if constexpr (std::is_same_v<S, Frustum>)
        return Conical{s.baseRadius, s.topRadius, s.height, true, true};
    else
        return std::nullopt;
}

std::optional<SurfaceHit> hitPlane(const RealRay& ray, const Plane& plane) {
    const RealVec3 normal = normalised(RealVec3(plane.normal));
    const Real slope = dot(normal, ray.direction);
    Nearest nearest;
    if (slope != 0) nearest.add((plane.distance - dot(normal, ray.origin)) / slope, normal);
    return nearest.hit();
}

/// Newell's normal, its length twice the area.
RealVec3 areaVector(const std::vector<RealVec3>& vertices) {
    RealVec3 sum;
    for (std::size_t i = 0; i < vertices.size(); ++i)
        sum = sum + cross(vertices[i] - vertices[0], vertices[(i + 1) % vertices.size()] - vertices[0]);
    return sum;
}

/// Even-odd, of the vertices as they lie seen along `direction`: a polygon need not be quite planar.
bool isInside(const std::vector<RealVec3>& vertices, const RealRay& ray) {
    const RealVec3& d = ray.direction;
    const RealVec3 u = normalised(abs(d.x) < abs(d.y) ? cross(d, {1, 0, 0}) : cross(d, {0, 1, 0})),
                   v = cross(d, u);
    bool inside = false;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const RealVec3 a = vertices[i] - ray.origin, b = vertices[(i + 1) % vertices.size()] - ray.origin;
        const Real ay = dot(a, v), by = dot(b, v);
        if ((ay > 0) == (by > 0)) continue;
        const Real ax = dot(a, u), bx = dot(b, u);
        if (ax + (bx - ax) * (-ay / (by - ay)) > 0) inside = !inside;
    }
    return inside;
}

/// By the areas opposite to the corners.
RealVec3 interpolatedNormal(const FaceSurface& face, const RealVec3& p, const RealVec3& area) {
    RealVec3 sum;
    for (std::size_t i = 0; i < 3; ++i) {
        const RealVec3 &b = face.vertices[(i + 1) % 3], &c = face.vertices[(i + 2) % 3];
        sum = sum + face.normals[i] * dot(cross(b - p, c - p), area);
    }
    return dot(sum, sum) == 0 ? normalised(area) : normalised(sum);
}

} // namespace

std::optional<SurfaceHit> firstHit(const FaceSurface& face, const RealRay& ray) {
    const RealVec3 area = areaVector(face.vertices);
    const Real slope = dot(area, ray.direction);
    if (slope == 0 || !isInside(face.vertices, ray)) return std::nullopt;
    RealVec3 mean;
    for (const RealVec3& vertex : face.vertices) mean = mean + vertex;
    mean = mean / Real(face.vertices.size());
    const Real t = dot(area, mean - ray.origin) / slope;
    if (t <= 0) return std::nullopt;
    return SurfaceHit{t, face.normals.empty() ? normalised(area) : interpolatedNormal(face, ray.at(t), area)};
}

std::optional<SurfaceHit> firstHit(const ShapeSurface& surface, const RealRay& ray) {
    return std::visit(
        [&]<class S>(const S& s) -> std::optional<SurfaceHit> {
            if constexpr (std::is_same_v<S, Plane>) {
                return hitPlane(ray, s);
            } else if constexpr (std::is_same_v<S, Polygon> || std::is_same_v<S, Mesh>) {
                return std::nullopt; // they are FaceSurfaces
            } else {
                const Local local{s.centre, surface};
                const RealRay own = local.ray(ray);
                if constexpr (std::is_same_v<S, Sphere>) {
                    return local.world(hitSphere(own, s.radius));
                } else if constexpr (std::is_same_v<S, Box>) {
                    return local.world(hitBox(own, s.sides));
                } else if constexpr (std::is_same_v<S, Disc>) {
                    Nearest nearest;
                    addDisc(nearest, own, 0, s.radius);
                    return local.world(nearest.hit());
                } else {
                    return local.world(hitConical(own, *conical(s)));
                }
            }
        },
        surface.shape);
}

Ball ballAround(const std::vector<Vec3>& vertices) {
    Ball ball;
    for (const Vec3 vertex : vertices) ball.centre += vertex / static_cast<double>(vertices.size());
    for (const Vec3 vertex : vertices) ball.radius = std::max(ball.radius, length(vertex - ball.centre));
    return ball;
}

Ball ballAround(const ShapeSurface& surface) {
    return std::visit(
        [&]<class S>(const S& s) -> Ball {
            if constexpr (std::is_same_v<S, Plane> || std::is_same_v<S, Polygon> || std::is_same_v<S, Mesh>)
                return {{}, 0, true};
            else if constexpr (std::is_same_v<S, Sphere> || std::is_same_v<S, Disc>)
                return {s.centre, s.radius};
            else if constexpr (std::is_same_v<S, Box>)
                return {s.centre, length(s.sides) / 2};
            else {
                const Conical c = *conical(s);
                const double height = c.height.template convert_to<double>();
                const double radius = std::max(c.base, c.top).template convert_to<double>();
                return {s.centre + surface.axes[1].rounded() * (height / 2), std::hypot(radius, height / 2)};
            }
        },
        surface.shape);
}

} // namespace yarte::validate
