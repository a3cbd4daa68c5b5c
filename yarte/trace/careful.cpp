// The crossings of all shapes in twice the precision: the formulas are those of the shapes' headers, without
// what they do to lose nothing in doubles.
#include "yarte/base/twofold.h"
#include "yarte/trace/world.h"

#include <optional>
#include <utility>

namespace yarte::trace {
namespace {

/// A line relative to a shape's centre, along its axes.
struct PreciseLine {
    Twofold3 p, d;

    PreciseLine(const Ray& ray, Vec3 centre) : p(Twofold3(ray.origin) - Twofold3(centre)), d(ray.direction) {}
    PreciseLine(const Ray& ray, Vec3 centre, const Frame& axes) : PreciseLine(ray, centre) {
        const auto toLocal = [&](Twofold3 v) {
            return Twofold3(dot(v, axes.x), dot(v, axes.y), dot(v, axes.z));
        };
        p = toLocal(p), d = toLocal(d);
    }
    Twofold heightAt(Twofold t) const { return p.y + t * d.y; }
};

struct PreciseNappe {
    Twofold slope, height, radius;
};

struct PreciseStretch {
    Twofold from = Bounds::infinity, to = -Bounds::infinity;
    std::uint8_t enterPart = 0, leavePart = 0;

    void set(Twofold a, Twofold b) { from = a, to = b; }
    bool empty() const { return !(from <= to); }

    /// Cuts off what lies beyond the plane at `height` of a line that goes up or down.
    void clip(const PreciseLine& line, Twofold height, bool keepsAbove, std::uint8_t part) {
        const Twofold t = (height - line.p.y) / line.d.y;
        if ((line.d.y > 0) == keepsAbove) {
            if (t > from) from = t, enterPart = part;
        } else if (t < to) {
            to = t, leavePart = part;
        }
    }
    Crossings crossings() const {
        Crossings result;
        if (empty()) return result;
        result.add(from.rounded(), enterPart, true);
        result.add(to.rounded(), leavePart, false);
        return result;
    }
};

PreciseStretch stretchInNappe(const PreciseLine& line, const PreciseNappe& nappe) {
    const auto& [p, d] = line;
    const Twofold x = p.x, z = p.z, r = nappe.slope * (nappe.height - p.y) + nappe.radius;
    const Twofold dr = -(nappe.slope * d.y);
    const Twofold a = d.x * d.x + d.z * d.z - dr * dr;
    const Twofold b = x * d.x + z * d.z - r * dr;
    const Twofold c = x * x + z * z - r * r;
    const Twofold xr = x * dr - r * d.x, zr = z * dr - r * d.z, xz = x * d.z - z * d.x;
    const Twofold discriminant = xr * xr + zr * zr - xz * xz;
    PreciseStretch result;
    if (a == 0) {
        if (b < 0 && dr > 0) result.set(-c / (b * 2), Bounds::infinity);
        if (b > 0 && dr < 0) result.set(-Bounds::infinity, -c / (b * 2));
        if (dr == 0 && c <= 0) result.set(-Bounds::infinity, Bounds::infinity);
        return result;
    }
    if (discriminant < 0 && a > 0) return result;
    const Twofold h = sqrt(discriminant);
    const Twofold sum = b < 0 ? h - b : -(b + h);
    Twofold low = sum / a, high = sum == 0 ? low : c / sum;
    if (high < low) std::swap(low, high);
    if (a > 0) {
        if (r - b / a * dr > 0) result.set(low, high);
    } else {
        dr > 0 ? result.set(high, Bounds::infinity) : result.set(-Bounds::infinity, low);
    }
    return result;
}

/// Where `height` over a plane becomes 0 along a line that falls by `fall`; nothing if that is nowhere.
std::optional<Twofold> meeting(Twofold height, Twofold fall) {
    if (fall == 0) return std::nullopt;
    const Twofold t = height / fall;
    if (!std::isfinite(t.rounded())) return std::nullopt;
    return t;
}

} // namespace

Crossings carefulCrossings(const Sphere& s, const Ray& ray) {
    const auto [u, d] = PreciseLine(ray, s.centre);
    const Twofold3 w = cross(u, d); // |w|^2 = d.d |nearest|^2
    const Twofold r2 = Twofold::product(s.radius, s.radius), dd = dot(d, d), b = -dot(u, d);
    const Twofold discriminant = dd * r2 - dot(w, w);
    if (discriminant < 0) return {};
    const Twofold h = sqrt(discriminant), sum = b < 0 ? b - h : b + h;
    Twofold low = sum / dd, high = sum == 0 ? low : (dot(u, u) - r2) / sum;
    if (high < low) std::swap(low, high);
    PreciseStretch inside;
    inside.set(low, high);
    return inside.crossings();
}

Crossings carefulCrossings(const Box& b, const Ray& ray) {
    const auto [p, d] = PreciseLine(ray, b.centre, b.axes);
    const Twofold origin[3] = {p.x, p.y, p.z}, direction[3] = {d.x, d.y, d.z};
    const double half[3] = {b.half.x, b.half.y, b.half.z};
    PreciseStretch inside;
    inside.set(-Bounds::infinity, Bounds::infinity);
    for (std::uint8_t axis = 0; axis < 3; ++axis) {
        if (direction[axis] == 0) {
            if (abs(origin[axis]) > half[axis]) return {};
            continue;
        }
        const bool isRising = direction[axis] > 0;
        const double near = isRising ? -half[axis] : half[axis];
        const Twofold enter = (near - origin[axis]) / direction[axis],
                      leave = (-near - origin[axis]) / direction[axis];
        const auto side = [&](bool isHigh) { return static_cast<std::uint8_t>(2 * axis + (isHigh ? 1 : 0)); };
        if (enter > inside.from) inside.from = enter, inside.enterPart = side(!isRising);
        if (leave < inside.to) inside.to = leave, inside.leavePart = side(isRising);
    }
    return inside.crossings();
}

Crossings carefulCrossings(const Cone& c, const Ray& ray) {
    const PreciseLine line(ray, c.centre, c.axes);
    PreciseStretch inside = stretchInNappe(line, {Twofold(c.radius) / c.height, c.height, 0});
    if (line.d.y == 0) {
        if (line.p.y < 0) return {};
    } else {
        inside.clip(line, 0, true, 1);
    }
    return inside.crossings();
}

Crossings carefulCrossings(const Frustum& f, const Ray& ray) {
    const PreciseLine line(ray, f.centre, f.axes);
    PreciseStretch inside =
        stretchInNappe(line, {(Twofold(f.baseRadius) - f.topRadius) / f.height, f.height, f.topRadius});
    if (line.d.y == 0) {
        if (line.p.y < 0 || line.p.y > f.height) return {};
    } else {
        inside.clip(line, 0, true, 1);
        inside.clip(line, f.height, false, 2);
    }
    return inside.crossings();
}

Crossings carefulCrossings(const TruncatedCone& c, const Ray& ray) {
    const PreciseLine line(ray, c.centre, c.axes);
    const bool isTube = c.nappe.slope == 0;
    const Twofold slope = isTube ? Twofold(0) : Twofold(c.radius) / c.nappe.height;
    const PreciseStretch inside = stretchInNappe(line, {slope, c.nappe.height, c.nappe.radius});
    Crossings result;
    if (inside.empty()) return result;
    const auto isKept = [&](Twofold t) {
        if (!std::isfinite(t.rounded())) return false;
        const Twofold y = line.heightAt(t);
        return y >= 0 && y <= c.height;
    };
    if (isKept(inside.from)) result.add(inside.from.rounded(), 0, true);
    if (isKept(inside.to)) result.add(inside.to.rounded(), 0, false);
    return result;
}

Crossings carefulCrossings(const Disc& s, const Ray& ray) {
    const auto [u, d] = PreciseLine(ray, s.centre);
    const Twofold fall = -dot(d, s.normal);
    Crossings result;
    const auto t = meeting(dot(u, s.normal), fall);
    if (!t) return result;
    const Twofold3 fromCentre = u + d * *t;
    if (dot(fromCentre, fromCentre) <= Twofold::product(s.radius, s.radius))
        result.add(t->rounded(), 0, fall > 0);
    return result;
}

Crossings carefulCrossings(const Plane& s, const Ray& ray) {
    const Twofold fall = -dot(Twofold3(ray.direction), s.normal);
    Crossings result;
    if (const auto t = meeting(dot(Twofold3(ray.origin), s.normal) - s.distance, fall))
        result.add(t->rounded(), 0, fall > 0);
    return result;
}

Crossings carefulCrossings(std::span<const std::uint32_t> corners, const Vec3* vertices, double rounding,
                           const Ray& ray) {
    const Twofold3 d(ray.direction);
    const double ax = std::abs(ray.direction.x), ay = std::abs(ray.direction.y),
                 az = std::abs(ray.direction.z);
    const auto rotated = [&](Twofold3 v) { // the largest component of the direction comes last
        return ax > ay && ax > az      ? Twofold3(v.y, v.z, v.x)
               : ay > az && !(ax > ay) ? Twofold3(v.z, v.x, v.y)
                                       : v;
    };
    const Twofold3 along = rotated(d);
    struct PreciselySeen {
        Twofold x, y;
    };
    // Times the direction's last component, but turned as Shear does: of an edge that is met exactly, too,
    // one of two neighbours counts, and the same one.
    const auto see = [&](std::uint32_t vertex) -> PreciselySeen {
        const Twofold3 p = rotated(Twofold3(vertices[vertex]) - Twofold3(ray.origin));
        const Twofold x = p.x * along.z - along.x * p.z, y = p.y * along.z - along.y * p.z;
        return along.z < 0 ? PreciselySeen{-x, -y} : PreciselySeen{x, y};
    };
    bool isInside = false;
    PreciselySeen previous = see(corners.back());
    for (const std::uint32_t vertex : corners) {
        const PreciselySeen next = see(vertex);
        const bool isAbove = previous.y > 0, isNextAbove = next.y > 0;
        if (isAbove != isNextAbove) {
            const Twofold determinant = previous.x * next.y - next.x * previous.y;
            if (isNextAbove ? determinant > 0 : determinant < 0) isInside = !isInside;
        }
        previous = next;
    }
    Crossings result;
    if (!isInside) return result;

    const Twofold3 first(vertices[corners[0]]);
    Twofold3 normal, sum;
    for (std::size_t i = 1; i < corners.size(); ++i) {
        const Twofold3 edge = Twofold3(vertices[corners[i]]) - first;
        if (i + 1 < corners.size()) normal = normal + cross(edge, Twofold3(vertices[corners[i + 1]]) - first);
        sum = sum + edge;
    }
    const bool isTriangle = corners.size() == 3;
    const Twofold3 anchor =
        isTriangle ? first : first + sum * (Twofold(1) / static_cast<double>(corners.size()));
    const Twofold height = dot(Twofold3(ray.origin) - anchor, normal), fall = -dot(d, normal);
    const bool isOff =
        ray.from.element == ElementId{} || std::abs(height.rounded()) > rounding * length(normal.rounded());
    if (const auto t = meeting(height, fall); t && isOff) result.add(t->rounded(), 0, fall > 0);
    return result;
}

} // namespace yarte::trace
