// Surfaces: where a line may cross the shapes of a scene, and what decides whether it does.
//
// Every shape is a set of bounded pieces of planes and quadrics (a tracer may think of solids instead).
// A line o + t d, with d of any length, meets the whole plane or quadric at a t that is rational or the root
// of a quadratic equation in the inputs; whether the piece reaches there is a matter of signs. The equations:
//
// - plane n.p = e: t = (e - n.o) / n.d
// - disc: plane, and |n x (u x d)|^2 <= r^2 (n.d)^2, u = o - centre
// - box: planes l_i = +-h_i in its own axes, and |l_j| <= h_j of the two others
// - sphere, and the mantle of cones and cylinders: v' M v = 0, where v = v0 + t dv is u with r, M = diag(1,
// 1,
//   1, -1); or (x, z, w) in the shape's axes, w the radius at height y, which is linear in it, M = diag(1, 1,
//   -1). Multiplied by the height, w needs no division. With a = dv' M dv, b = v0' M dv, c = v0' M v0 the
//   roots are (-b +- sqrt(b^2 - a c)) / a, and b^2 - a c is, by Lagrange's identity, a sum of squares of 2 x
//   2 determinants of v0 and dv. The mantle reaches from y = 0 to the height.
// - polygon: Newell's plane through the mean (of a triangle: any) vertex; inside where a half-plane that
//   ends in the line is crossed by an odd number of edges: signs of volumes
#pragma once

#include "tests/hard/decision.h"
#include "tests/hard/inputs.h"
#include "yarte/scene/scene.h"

#include <algorithm>
#include <functional>

namespace yarte::hard {

template <class N>
struct Line {
    Vec<N> o, d;
};

/// Where a line may cross one piece of surface.
template <class N>
struct Candidate {
    std::size_t body = 0, face = 0; ///< face: of a mesh
    Surd<N> t;
    bool entering = true; ///< against the outward normal
    Decision exists; ///< sign >= 0 if it does; of all that decides that the weakest or, if it does not, the
                     ///< strongest
    std::function<Vec<N>(const N& t)> normal; ///< of any length
};

template <class N>
class SurfaceFinder {
public:
    SurfaceFinder(Inputs<N>& inputs, const Line<N>& line, const Scene& scene)
        : in_(inputs), line_(line), scene_(scene) {
        for (body_ = 0; body_ < scene.bodies.size(); ++body_)
            std::visit([&](const auto& shape) { find(shape, scene.bodies[body_].referential); },
                       scene.bodies[body_].shape);
    }

    std::vector<Candidate<N>> candidates;
    /// Decisions that there is nothing to be met.
    std::vector<Decision> absences;

private:
    using V = Vec<N>;

    void add(const Surd<N>& t, bool entering, const std::vector<Decision>& conditions,
             std::function<V(const N&)> normal, std::size_t face = 0) {
        candidates.push_back({body_, face, t, entering, conjunction(conditions), std::move(normal)});
    }

    /// Whatever the sign: that it is known.
    static Decision known(Decision d) {
        d.sign = 1;
        return d;
    }
    static Decision unknown(Decision d) {
        d.sign = 1, d.strength = 0;
        return d;
    }

    static Decision conjunction(const std::vector<Decision>& all) {
        Decision weakest = signOf(Rational(1), "nothing"), strongestFailure;
        bool fails = false;
        for (const Decision& d : all) {
            if (d.sign >= 0) {
                weakest = weaker(weakest, d);
            } else {
                strongestFailure = fails ? stronger(strongestFailure, d) : d;
                fails = true;
            }
        }
        return fails ? strongestFailure : weakest;
    }

    /// Coordinates relative to a centre, along a body's axes.
    struct Local {
        std::optional<Axes<N>> axes;
        V u, o, d; ///< u: relative to the centre; o, d: of the line, along the axes

        V toWorld(const V& v) const { return axes ? axes->x * v.x + axes->y * v.y + axes->z * v.z : v; }
        V toLocal(const V& v) const {
            return axes ? V{dot(v, axes->x), dot(v, axes->y), dot(v, axes->z)} : v;
        }
    };
    Local local(const Vec3& centre, const std::optional<Referential>& referential) {
        Local l{axesOf(in_, referential), line_.o - vectorOf(in_, centre), {}, {}};
        l.o = l.toLocal(l.u), l.d = l.toLocal(line_.d);
        return l;
    }

    static Surd<N> rational(const N& t) { return {t, N(0), N(0)}; }

    /// alpha + beta t
    static Surd<N> linear(const N& alpha, const N& beta, const Surd<N>& t) {
        return {alpha + beta * t.p, beta * t.q, t.d};
    }

    /// `visit(t, entering)` for the roots of a t^2 + 2 b t + c, whose discriminant / 4 is given.
    template <class Visit>
    void roots(const N& a, const N& b, const N& c, const N& discriminant, Visit&& visit) {
        const Decision d = signOf(discriminant, "discriminant"), leading = signOf(a, "leading coefficient"),
                       half = signOf(b, "linear coefficient");
        if (d.sign < 0 && leading.sign > 0) {
            if (d.isCertain()) return absences.push_back(d);
            visit(rational(-b / a), true, unknown(d)); // maybe
            return;
        }
        if (leading.sign != 0 && leading.isCertain()) {
            const N q = 1 / a;
            visit(Surd<N>{-b * q, -q, discriminant}, true, d);
            visit(Surd<N>{-b * q, q, discriminant}, false, d);
        } else if (half.sign != 0 && half.isCertain()) {
            // Parallel to a generator: the other root is at infinity or, for inputs half an ulp off, far
            // beyond the shape's ends.
            const N root = half.sign > 0 ? rootOf(discriminant, b) : -rootOf(discriminant, b);
            visit(rational(-c / (b + root)), half.sign < 0, known(half));
        } else if (!isExactlyZero(leading) || !isExactlyZero(half)) {
            absences.push_back(unknown(weaker(leading, half)));
        } else {
            absences.push_back(signOf(c, "distance from a parallel mantle"));
        }
    }
    /// sqrt(b^2 - a c) where a is 0, or as good as.
    static Rational rootOf(const Rational&, const Rational& b) { return abs(b); }
    static Uncertain rootOf(const Uncertain& discriminant, const Uncertain&) { return sqrt(discriminant); }

    void find(const Sphere& s, const std::optional<Referential>&) {
        const V u = line_.o - vectorOf(in_, s.centre), w = cross(u, line_.d);
        const N r = in_.number(s.radius), a = dot(line_.d, line_.d), b = dot(u, line_.d);
        roots(a, b, dot(u, u) - r * r, a * r * r - dot(w, w),
              [&](const Surd<N>& t, bool entering, Decision exists) {
                  add(t, entering, {exists}, [=, d = line_.d](const N& at) { return u + d * at; });
              });
    }

    void find(const Box& b, const std::optional<Referential>& referential) {
        const Local l = local(b.centre, referential);
        const N o[3] = {l.o.x, l.o.y, l.o.z}, d[3] = {l.d.x, l.d.y, l.d.z};
        const N twice[3] = {in_.number(b.sides.x), in_.number(b.sides.y), in_.number(b.sides.z)};
        for (int i = 0; i < 3; ++i) {
            const Decision slope = signOf(d[i], "slope to a face");
            if (isExactlyZero(slope)) continue;
            for (const int side : {-1, 1}) {
                const N gap = N(side) * twice[i] - 2 * o[i]; // twice what is left to the face
                std::vector<Decision> conditions{known(slope)};
                for (int j = 0; j < 3; ++j) {
                    if (j == i) continue;
                    for (const int end : {-1, 1}) { // twice_j >= +-2 l_j, all times d_i
                        Decision within =
                            signOf(twice[j] * d[i] + N(end) * (2 * o[j] * d[i] + gap * d[j]), "edge");
                        within.sign *= slope.sign;
                        conditions.push_back(within);
                    }
                }
                const V normal{N(i == 0 ? side : 0), N(i == 1 ? side : 0), N(i == 2 ? side : 0)};
                add(rational(gap / (2 * d[i])), slope.sign * side < 0, conditions,
                    [=](const N&) { return l.toWorld(normal); });
            }
        }
    }

    /// A mantle from y = 0 to `height`, whose radius there is (r0 h + (r1 - r0) y) / h.
    void mantle(const Local& l, const N& r0, const N& r1, const N& h, const N& height) {
        const N x = l.o.x * h, z = l.o.z * h, w = r0 * h + (r1 - r0) * l.o.y;
        const N dx = l.d.x * h, dz = l.d.z * h, dw = (r1 - r0) * l.d.y;
        const N xw = x * dw - w * dx, zw = z * dw - w * dz, xz = x * dz - z * dx;
        roots(dx * dx + dz * dz - dw * dw, x * dx + z * dz - w * dw, x * x + z * z - w * w,
              xw * xw + zw * zw - xz * xz, [&](const Surd<N>& t, bool entering, Decision exists) {
                  add(t, entering,
                      {exists, signOf(linear(l.o.y, l.d.y, t), "lower rim"),
                       signOf(linear(height - l.o.y, -l.d.y, t), "upper rim")},
                      [=](const N& at) {
                          return l.toWorld({(x + dx * at) * h, (w + dw * at) * (r0 - r1), (z + dz * at) * h});
                      });
              });
    }
    /// The disc across the axis at `y`, facing up or down.
    void cap(const Local& l, const N& r, const N& y, bool facesUp) {
        const Decision slope = signOf(l.d.y, "slope to a disc");
        if (isExactlyZero(slope)) return;
        const N gap = y - l.o.y, x = l.o.x * l.d.y + gap * l.d.x, z = l.o.z * l.d.y + gap * l.d.z;
        add(rational(gap / l.d.y), (slope.sign > 0) != facesUp,
            {known(slope), signOf(r * r * l.d.y * l.d.y - x * x - z * z, "rim")}, [=](const N&) {
                return l.toWorld({N(0), N(facesUp ? 1 : -1), N(0)});
            });
    }

    void find(const Cone& c, const std::optional<Referential>& referential) {
        const Local l = local(c.centre, referential);
        const N r = in_.number(c.radius), h = in_.number(c.height);
        mantle(l, r, N(0), h, h);
        cap(l, r, N(0), false);
    }
    void find(const TruncatedCone& c, const std::optional<Referential>& referential) {
        const Local l = local(c.centre, referential);
        const N r = in_.number(c.radius), h = in_.number(c.coneHeight);
        // Two numbers in the scene, but where they are the same the cone ends in its apex, whatever they are.
        mantle(l, r, N(0), h, c.height == c.coneHeight ? h : in_.number(c.height));
    }
    void find(const Cylinder& c, const std::optional<Referential>& referential) {
        const Local l = local(c.centre, referential);
        const N r = in_.number(c.radius), h = in_.number(c.height);
        tube(l, r, h);
        cap(l, r, N(0), false), cap(l, r, h, true);
    }
    void find(const OpenCylinder& c, const std::optional<Referential>& referential) {
        tube(local(c.centre, referential), in_.number(c.radius), in_.number(c.height));
    }
    void tube(const Local& l, const N& r, const N& h) { mantle(l, r, r, N(1), h); }
    void find(const Frustum& f, const std::optional<Referential>& referential) {
        const Local l = local(f.centre, referential);
        const N r0 = in_.number(f.baseRadius), r1 = in_.number(f.topRadius), h = in_.number(f.height);
        mantle(l, r0, r1, h, h);
        cap(l, r0, N(0), false), cap(l, r1, h, true);
    }

    void find(const Disc& s, const std::optional<Referential>& referential) {
        const V u = line_.o - vectorOf(in_, s.centre);
        const auto axes = axesOf(in_, referential);
        const V n = axes ? axes->y : V{N(0), N(1), N(0)};
        const V fromCentre = cross(n, cross(u, line_.d));
        const N r = in_.number(s.radius), rise = dot(n, line_.d);
        meetPlane(-dot(n, u), rise, {signOf(r * r * rise * rise - dot(fromCentre, fromCentre), "rim")}, n, 0);
    }
    void find(const Plane& s, const std::optional<Referential>&) {
        const V n = vectorOf(in_, exactUnit(s.normal));
        meetPlane(in_.number(s.distance) - dot(n, line_.o), dot(n, line_.d), {}, n, 0);
    }
    /// A piece of a plane that is `gap` ahead along its normal.
    void meetPlane(const N& gap, const N& rise, std::vector<Decision> conditions, const V& normal,
                   std::size_t face) {
        const Decision slope = signOf(rise, "slope to the plane");
        if (isExactlyZero(slope)) return absences.push_back(slope);
        conditions.push_back(known(slope));
        add(
            rational(gap / rise), slope.sign < 0, conditions, [=](const N&) { return normal; }, face);
    }

    void find(const Polygon& p, const std::optional<Referential>&) {
        std::vector<V> vertices;
        for (const Vec3& v : p.vertices) vertices.push_back(vectorOf(in_, v));
        findFace(vertices, 0);
    }
    /// Placed as it is: of a mesh that is turned or scaled the placed vertices would be the inputs.
    void find(const Mesh& m, const std::optional<Referential>&) {
        const MeshData& data = scene_.meshes[m.mesh.index];
        std::vector<V> all;
        for (const Vec3& v : data.vertices) all.push_back(vectorOf(in_, v));
        for (std::size_t f = 0; f < data.faceCount(); ++f) {
            std::vector<V> vertices;
            for (const std::uint32_t corner : data.face(f)) vertices.push_back(all[corner]);
            findFace(vertices, f);
        }
    }
    void findFace(const std::vector<V>& vertices, std::size_t face) {
        const Decision inside = isInside(vertices);
        if (inside.sign < 0 && inside.isCertain()) return absences.push_back(inside);
        V normal{N(0), N(0), N(0)}, sum = normal;
        for (std::size_t i = 1; i < vertices.size(); ++i) {
            const V edge = vertices[i] - vertices[0];
            if (i + 1 < vertices.size()) normal = normal + cross(edge, vertices[i + 1] - vertices[0]);
            sum = sum + edge;
        }
        V toAnchor = vertices[0] - line_.o;
        if (vertices.size() > 3) toAnchor = toAnchor + sum * N(1 / N(static_cast<int>(vertices.size())));
        meetPlane(dot(normal, toAnchor), dot(normal, line_.d), {inside}, normal, face);
    }
    /// Half-planes in several directions: any of them decides, and the best one proves it.
    Decision isInside(const std::vector<V>& vertices) const {
        Decision best;
        bool first = true;
        constexpr int directions[][3] = {{1, 0, 0},  {0, 1, 0},  {0, 0, 1},  {3, 5, 2},
                                         {-4, 2, 5}, {2, -3, 4}, {-5, -4, 1}};
        for (const auto& e : directions) {
            const V across = cross(line_.d, V{N(e[0]), N(e[1]), N(e[2])});
            if (isExactlyZero(signOf(dot(across, across), ""))) continue;
            const Decision d = isInside(vertices, across);
            if (first || d.strength > best.strength) best = d;
            first = false;
            if (best.strength > 1e6 || vertices.size() > 100) break;
        }
        return best;
    }
    Decision isInside(const std::vector<V>& vertices, const V& across) const {
        std::vector<Decision> above;
        for (const V& v : vertices) above.push_back(signOf(dot(v - line_.o, across), "vertex"));
        Decision result = signOf(Rational(1), "edges");
        bool inside = false;
        for (std::size_t i = 0; i < vertices.size(); ++i) {
            const std::size_t j = (i + 1) % vertices.size();
            result = weaker(result, above[i]);
            const bool iAbove = above[i].sign > 0, jAbove = above[j].sign > 0;
            if (iAbove == jAbove) continue;
            const Decision volume =
                signOf(dot(line_.d, cross(vertices[i] - line_.o, vertices[j] - line_.o)), "edge");
            if ((volume.sign > 0) == jAbove && volume.sign != 0) inside = !inside;
            result = weaker(result, volume);
        }
        result.sign = inside ? 1 : -1;
        return result;
    }

    Inputs<N>& in_;
    const Line<N>& line_;
    const Scene& scene_;
    std::size_t body_ = 0;
};

} // namespace yarte::hard
