// Nappe: the solid of revolution around the y axis whose radius is linear in y, where that radius is not
// negative: what cones, and cylinders as those without slope, are cut from.
#pragma once

#include "yarte/base/frame.h"
#include "yarte/trace/bounds.h"
#include "yarte/trace/ray.h"

namespace yarte::trace {

/// The radius at y is radius + slope * (height - y). Given at the place where it must be exact, which is the
/// apex of a cone.
struct Nappe {
    double slope, height, radius;
};

/// A ray's line as a shape with its own axes sees it: p + (t - moved) d, p relative to the shape's centre. The
/// shape lies within `radius` of its axis, from the centre up to the height, so no part of it is farther than
/// `reach`. A start farther away than one and a half times the radius is first moved to where the line is
/// nearest to the place of the axis that it started beside: turning a distant one into other axes would spread
/// the rounding of its largest coordinate to all of them. t, at least a third of what it is moved by, loses
/// less than two bits by that.
///
/// `far` bounds what the coordinates of p, and those that were rounded on the way to it, are of a line that
/// comes within reach of the centre. Others are far from every decision.
struct LocalLine {
    Vec3 p, d;
    double moved, reach, far;

    LocalLine(const Ray& ray, Vec3 centre, const Frame& axes, double radius, double height)
        : reach(radius + height) {
        const Vec3 u = ray.origin - centre;
        d = axes.toLocal(ray.direction);
        const double beside = std::min(std::max(dot(u, axes.y), 0.0), height);
        const double nearest = beside * d.y - dot(u, ray.direction);
        moved = std::abs(nearest) > 1.5 * radius ? nearest : 0;
        p = axes.toLocal(u + moved * ray.direction);
        far = 2.5 * reach + std::abs(moved);
    }
};

/// The stretch of a line inside a nappe; empty where from > to; an end may be infinite.
struct Stretch {
    double from = Bounds::infinity, to = -Bounds::infinity;
    bool isDoubtful = false;        ///< as Crossings::isDoubtful
    double blur = 0, steepness = 1; ///< the ends are good to blur / steepness

    void set(double a, double b) { from = a, to = b; }
    bool empty() const { return !(from <= to); }
    /// True if an end is where the height is that, as far as rounding tells.
    bool endsAt(double height, const LocalLine& line) const {
        const double y = line.p.y, dy = line.d.y;
        return std::min(std::abs(y + from * dy - height), std::abs(y + to * dy - height)) * steepness <= blur;
    }
    /// True if an end is where the ray starts.
    bool endsAtStart(const LocalLine& line) const {
        return std::min(std::abs(line.moved + from), std::abs(line.moved + to)) * steepness <= blur;
    }
};

/// Where the line is inside a nappe without slope, counted from p: a t^2 + 2 b t + c = 0 over the squares of
/// x and z, with b^2 - a c, which cancels badly, as r^2 a - (x dz - z dx)^2 by Lagrange's identity.
///
/// How good this is: x and z to some 2^-51 far, the discriminant to 2 k times that, k being no less than the
/// numbers that it is made of. The ends are good to 2^-26 of the shape's size and 2^-42 far, over a, with
/// room to spare.
inline Stretch stretchInCylinder(const LocalLine& line, double r) {
    const Vec3 p = line.p, d = line.d;
    const double a = d.x * d.x + d.z * d.z, b = p.x * d.x + p.z * d.z, c = p.x * p.x + p.z * p.z - r * r;
    const double xz = p.x * d.z - p.z * d.x;
    const double discriminant = r * r * a - xz * xz;

    const double k = r + std::abs(xz), w = 0x1p-24 * k + 0x1p-43 * line.far, discriminantBlur = (k + w) * w;
    Stretch result;
    result.isDoubtful = std::abs(discriminant) <= discriminantBlur || a == 0;
    result.blur = 0x1p-26 * line.reach + 0x1p-42 * line.far, result.steepness = a;
    if (a == 0) { // along the axis: inside everywhere or nowhere
        if (c <= 0) result.set(-Bounds::infinity, Bounds::infinity);
        return result;
    }
    if (discriminant < 0) return result;
    const double h = std::sqrt(discriminant), sum = -(b < 0 ? b - h : b + h);
    const double root1 = sum / a, root2 = sum != 0 ? c / sum : root1;
    result.set(std::min(root1, root2), std::max(root1, root2));
    return result;
}

/// The same with a slope.
///
/// With r the radius at y and M = diag(1, 1, -1) over v = (x, z, r), which is linear in t, the surface is v'
/// M v = 0. The start is first moved along the line to where v is shortest, so that what is rounded in a,
/// which may cancel, does not count for the whole way there: v.dv = 0, so b is -2 r dr but for rounding, and
/// the middle of the roots, -b/a, lies at a radius of r |dv|^2 / a, which has the signs of r and a. The
/// discriminant is (x dr - r dx)^2
/// + (z dr - r dz)^2 - (x dz - z dx)^2. Nothing here divides by the slope.
///
/// How good this is: as above, with determinants of size k. Near a generator's direction a cancels.
inline Stretch stretchInCone(const LocalLine& line, const Nappe& nappe) {
    const Vec3 p = line.p, d = line.d;
    const double start = nappe.slope * (nappe.height - p.y) + nappe.radius, dr = nappe.slope * -d.y;
    const double dd = d.x * d.x + d.z * d.z, m = dd + dr * dr;
    const double moved = -(p.x * d.x + p.z * d.z + start * dr) / m;
    const double x = p.x + moved * d.x, y = p.y + moved * d.y, z = p.z + moved * d.z;
    const double r = nappe.slope * (nappe.height - y) + nappe.radius;

    const double a = dd - dr * dr, b = x * d.x + z * d.z - r * dr, c = x * x + z * z - r * r;
    const double xr = x * dr - r * d.x, zr = z * dr - r * d.z, xz = x * d.z - z * d.x;
    const double discriminant = xr * xr + zr * zr - xz * xz;

    const double far = line.far + std::abs(start), k = std::abs(xr) + std::abs(zr) + std::abs(xz);
    const double w = 0x1p-24 * k + 0x1p-44 * (2 + nappe.slope * nappe.slope) * far;
    const double discriminantBlur = (k + w) * w;
    Stretch result;
    result.isDoubtful = std::abs(discriminant) <= discriminantBlur || std::abs(a) <= 0x1p-16 * m ||
                        std::abs(r) <= 0x1p-40 * far;
    result.blur = 0x1p-26 * line.reach + 0x1p-42 * far, result.steepness = std::min(1.0, std::abs(a));
    if (a == 0) { // parallel to a generator: one root, and the solid beyond it
        if (b < 0 && dr > 0) result.set(moved - c / (2 * b), Bounds::infinity);
        if (b > 0 && dr < 0) result.set(-Bounds::infinity, moved - c / (2 * b));
        return result;
    }
    if (discriminant < 0 && a > 0) return result;
    const double h = std::sqrt(std::max(discriminant, 0.0)), sum = -(b < 0 ? b - h : b + h);
    const double root1 = sum / a, root2 = sum != 0 ? c / sum : root1;
    const double low = moved + std::min(root1, root2), high = moved + std::max(root1, root2);
    if (a > 0) { // both roots on one nappe: ours if the middle of the chord has a positive radius
        if (r > 0) result.set(low, high);
    } else { // steeper than a generator: one root on each nappe, and the radius grows towards ours
        dr > 0 ? result.set(high, Bounds::infinity) : result.set(-Bounds::infinity, low);
    }
    return result;
}

inline Stretch stretchInNappe(const LocalLine& line, const Nappe& nappe) {
    return nappe.slope == 0 ? stretchInCylinder(line, nappe.radius) : stretchInCone(line, nappe);
}

/// The outward normal at a local point of the surface: radial, tilted up by the slope. At the apex, the axis.
inline Vec3 nappeNormal(Vec3 p, const Nappe& nappe) {
    const double distance = std::sqrt(p.x * p.x + p.z * p.z);
    if (distance == 0) return {0, 1, 0};
    return normalised({p.x / distance, nappe.slope, p.z / distance});
}

} // namespace yarte::trace
