#include "tests/hard/attack.h"

#include "yarte/scene/referential.h"

#include <functional>
#include <numbers>
#include <stdexcept>

namespace yarte::hard {
namespace {

/// Where a decision changes, in the shape's own axes: at `point`, for lines along `along` that move along
/// `across`. None along: in any direction; none across: to any side.
struct Brink {
    Vec3 point, along, across;
};

class Attacker {
public:
    explicit Attacker(test::Random& random) : random_(random) {}

    Case attack(std::string_view shape) {
        isShort_ = random_.below(4) == 0;
        centre_ = random_.below(3) == 0 ? Vec3{} : shorten(random_.direction() * logarithmic(1e-2, 1e3));
        if (const int turn = random_.below(3); turn == 1 && !isShort_) {
            axes_ = random_.referential();
        } else if (turn == 2) {
            axes_ = Referential{{0, 0, 1}, {random_.below(2) == 0 ? 1.0 : -1.0, 0, 0}, {}};
        }
        const Brink brink = make(shape);
        Case result;
        result.scene = test::emptyScene();
        test::add(result.scene, shape_, test::matt({1, 1, 1})).referential = axes_;
        result.ray = rayAt(brink);
        return result;
    }

private:
    double logarithmic(double low, double high) {
        return std::exp(random_.between(std::log(low), std::log(high)));
    }
    /// A length; half of them near 1.
    double size() {
        return shorten(random_.below(2) == 0 ? random_.between(0.5, 2) : logarithmic(1e-4, 1e4));
    }
    /// Seven bits, if numbers are to be short.
    double shorten(double x) const {
        if (!isShort_ || x == 0) return x;
        int exponent;
        const double mantissa = std::frexp(x, &exponent);
        return std::ldexp(std::round(mantissa * 128) / 128, exponent);
    }
    Vec3 shorten(Vec3 v) const { return {shorten(v.x), shorten(v.y), shorten(v.z)}; }
    /// In short numbers: on an axis or a diagonal of the local y axis.
    Vec3 around() {
        if (isShort_) {
            constexpr Vec3 axes[] = {{1, 0, 0}, {-1, 0, 0}, {0, 0, 1}, {0, 0, -1}};
            return axes[random_.below(4)];
        }
        const double angle = random_.between(0, 2 * std::numbers::pi);
        return {std::cos(angle), 0, std::sin(angle)};
    }
    bool one(int of) { return random_.below(of) == 0; }

    Brink make(std::string_view shape) {
        if (shape == "sphere") return sphere();
        if (shape == "box") return box();
        if (shape == "cone") return cone();
        if (shape == "truncated_cone") return truncatedCone();
        if (shape == "cylinder" || shape == "open_cylinder") return cylinder(shape == "cylinder");
        if (shape == "frustum") return frustum();
        if (shape == "disc") return disc();
        if (shape == "polygon" || shape == "triangle")
            return polygon(shape == "triangle" ? 3 : 4 + random_.below(4));
        if (shape == "plane") return plane();
        throw std::invalid_argument("no such shape");
    }

    /// A line that touches a surface there.
    Brink tangent(Vec3 point, Vec3 normal, Vec3 oneTangent) {
        const Vec3 other = cross(normal, oneTangent);
        const double angle = random_.between(0, 2 * std::numbers::pi);
        const Vec3 along = isShort_ ? (one(2) ? oneTangent : other)
                                    : normalised(std::cos(angle) * oneTangent + std::sin(angle) * other);
        return {point, along, normal};
    }

    Brink sphere() {
        const double r = size();
        shape_ = Sphere{centre_, r};
        axes_.reset();
        extent_ = r;
        const Vec3 n = isShort_ ? around() : random_.direction();
        return tangent(n * r, n, normalised(cross(n, std::abs(n.y) < 0.7 ? Vec3{0, 1, 0} : Vec3{1, 0, 0})));
    }
    Brink box() {
        Vec3 sides{size(), size(), size()};
        if (one(8)) sides.y *= 0x1p-40;
        shape_ = Box{centre_, sides};
        extent_ = std::max({sides.x, sides.y, sides.z});
        const Vec3 half = sides / 2;
        const Vec3 inside{random_.between(-1, 1) * half.x, random_.between(-1, 1) * half.y,
                          random_.between(-1, 1) * half.z};
        Vec3 p = isShort_ ? half / 4 : inside;
        switch (random_.below(4)) {
        case 0: p.x = half.x; return tangent(p, {1, 0, 0}, {0, 1, 0});   // in a face
        case 1: p.x = half.x, p.z = -half.z; return {p, {0, 1, 0}, {}};  // along an edge
        case 2: p.x = half.x, p.z = -half.z; return {p, {}, {1, 0, -1}}; // across it
        default: return {{half.x, -half.y, half.z}, {}, {}};
        }
    }
    /// What mantles have in common: a point at height y, where the radius is r and falls by `slope`.
    Brink mantle(double r, double y, double slope) {
        const Vec3 radial = around();
        const Vec3 n = normalised(radial + Vec3{0, slope, 0}),
                   generator = normalised(Vec3{0, 1, 0} - slope * radial);
        const Vec3 p = radial * r + Vec3{0, y, 0};
        if (one(3)) return {p, generator, n};
        if (one(3)) return {p * 0.5, generator, {}}; // parallel to one, inside
        return tangent(p, n, generator);
    }
    Brink rim(double r, double y) {
        const Vec3 radial = around();
        const Vec3 p = radial * r + Vec3{0, y, 0};
        switch (random_.below(3)) {
        case 0: return {p, {}, radial};
        case 1: return {p, {}, {0, 1, 0}};
        default: return {p, cross(radial, {0, 1, 0}), {}}; // along it
        }
    }
    Brink cone() {
        const double r = size(), h = size();
        shape_ = Cone{centre_, r, h};
        extent_ = std::max(r, h);
        const double part = isShort_ ? 0.25 : random_.between(0, 1);
        switch (random_.below(4)) {
        case 0: return {{0, h, 0}, {}, {}};
        case 1: return rim(r, 0);
        default: return mantle(r * (1 - part), h * part, r / h);
        }
    }
    Brink truncatedCone() {
        const double r = size(), full = one(4) ? r * 0x1p30 : size(),
                     h = shorten(full * random_.between(0.01, 1));
        shape_ = TruncatedCone{centre_, r, full, std::min(h, full)};
        extent_ = std::max(r, h);
        const double part = isShort_ ? 0.25 : random_.between(0, 1);
        switch (random_.below(4)) {
        case 0: return rim(r * (1 - h / full), h);
        case 1: return rim(r, 0);
        default: return mantle(r * (1 - part * h / full), h * part, r / full);
        }
    }
    Brink cylinder(bool isClosed) {
        const double r = size(), h = size();
        if (isClosed)
            shape_ = Cylinder{centre_, r, h};
        else
            shape_ = OpenCylinder{centre_, r, h};
        extent_ = std::max(r, h);
        const double part = isShort_ ? 0.25 : random_.between(0, 1);
        if (one(3)) return rim(r, one(2) ? 0 : h);
        return mantle(r, h * part, 0);
    }
    Brink frustum() {
        const double r = size(), h = size(),
                     top = one(3) ? r * (1 + std::ldexp(random_.below(3) - 1, -10 - 10 * random_.below(4)))
                                  : size();
        shape_ = Frustum{centre_, r, top, h};
        extent_ = std::max({r, top, h});
        const double part = isShort_ ? 0.25 : random_.between(0, 1);
        switch (random_.below(4)) {
        case 0: return rim(top, h);
        case 1: return rim(r, 0);
        default: return mantle(r + (top - r) * part, h * part, (r - top) / h);
        }
    }
    Brink disc() {
        const double r = size();
        shape_ = Disc{centre_, r};
        extent_ = r;
        return one(3) ? tangent(around() * (r / 2), {0, 1, 0}, {1, 0, 0}) : rim(r, 0);
    }
    Brink plane() {
        const Vec3 n = isShort_ ? shorten(random_.direction()) : random_.direction() * logarithmic(1e-2, 1e2);
        const double distance = shorten(random_.between(-1, 1) * size());
        shape_ = Plane{n, distance};
        axes_.reset(), centre_ = {};
        extent_ = std::max(1.0, std::abs(distance));
        const Vec3 u = unitVector(n);
        return tangent(u * distance, u, normalised(cross(u, random_.direction())));
    }
    /// Convex or not, in a plane as far as doubles are.
    Brink polygon(int count) {
        Polygon p;
        const double s = size(), flatness = one(3) ? 1e-2 : 1;
        const Frame frame = axes_ ? resolveReferential(*axes_) : Frame{};
        axes_.reset();
        for (int i = 0; i < count; ++i) {
            const double angle = 2 * std::numbers::pi * (i + random_.between(0, 0.8)) / count,
                         r = s * random_.between(count > 3 ? 0.3 : 0.7, 1);
            p.vertices.push_back(
                shorten(centre_ + frame.toWorld({r * std::cos(angle), 0, flatness * r * std::sin(angle)})));
        }
        const std::size_t i = static_cast<std::size_t>(random_.below(count));
        const Vec3 a = p.vertices[i], b = p.vertices[(i + 1) % p.vertices.size()];
        const Vec3 normal = frame.y;
        shape_ = p;
        extent_ = s;
        const Vec3 middle = a + (isShort_ ? 0.5 : random_.between(0, 1)) * (b - a);
        centre_ = {};
        switch (random_.below(4)) {
        case 0: return {a, {}, {}};
        case 1: return {(p.vertices[0] + p.vertices[1] + p.vertices[2]) / 3, {}, {}};
        case 2: return {middle, normalised(b - a), normal};
        default: return {middle, {}, cross(b - a, normal)};
        }
    }

    InputRay rayAt(const Brink& brink) {
        const Frame frame = axes_ ? resolveReferential(*axes_) : Frame{};
        const auto turned = [&](Vec3 v) {
            return v == Vec3{} ? random_.direction() : normalised(frame.toWorld(v));
        };
        Vec3 along = turned(brink.along), across = turned(brink.across);
        if (isShort_ && brink.along == Vec3{}) {
            constexpr Vec3 axes[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
            along = axes[random_.below(3)];
        }
        if (one(2)) along = -along;
        // Also leaning: nearly parallel to a surface is a decision of its own.
        if (one(4)) along = normalised(along + random_.direction() * logarithmic(1e-17, 1e-1));
        const double off = extent_ * logarithmic(1e-17, one(3) ? 1e-2 : 1e-12) * (one(2) ? 1 : -1);
        const Vec3 target = centre_ + frame.toWorld(brink.point) + across * (one(20) ? 0 : off);
        const double way = one(2) ? logarithmic(1, 10) : logarithmic(1e-2, 1e5);
        if (one(6)) return {shorten(target), random_.direction()}; // starts beside the surface
        const Vec3 origin = target - along * shorten(extent_ * way);
        if (isShort_) return {origin, along};
        return {origin, normalised(target - origin)};
    }

    test::Random& random_;
    bool isShort_ = false;
    Vec3 centre_;
    std::optional<Referential> axes_;
    Shape shape_;
    double extent_ = 1;
};

} // namespace

std::vector<std::string_view> attackedShapes() {
    return {"sphere",   "box",      "cone",          "truncated_cone", "disc", "polygon",
            "triangle", "cylinder", "open_cylinder", "frustum",        "plane"};
}

Case attack(std::string_view shape, test::Random& random) { return Attacker(random).attack(shape); }

} // namespace yarte::hard
