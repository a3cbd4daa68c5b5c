// Nappe: the solid of revolution around the y axis whose radius is linear in y, where that radius is not
// negative: what cones, and cylinders as those without slope, are cut from.
#pragma once

#include "yarte/trace/bounds.h"

namespace yarte::trace {

/// The radius at y is radius + slope * (height - y). Given at the place where it must be exact, which is the
/// apex of a cone.
struct Nappe {
    double slope, height, radius;
};

/// The stretch of a line inside a convex solid; empty where from > to; an end may be infinite.
struct Stretch {
    double from = Bounds::infinity, to = -Bounds::infinity;
    bool empty() const { return !(from <= to); }
};

/// Where the line p + t d is inside the nappe. `p` is relative to the base centre; `d` has unit length.
///
/// With r the radius at y and M = diag(1, 1, -1) over (x, z, r), all linear in t, the surface is
/// (p + t d)' M (p + t d) = 0: a t^2 + 2 b t + c. b^2 - a c cancels badly; by Lagrange's identity it is
/// (x dr - r dx)^2 + (z dr - r dz)^2 - (x dz - z dx)^2. Nothing here divides by the slope, which may be 0.
/// The origin is first moved to the point of the line nearest to the base centre, so that a distant one loses
/// nothing.
inline Stretch stretchInNappe(Vec3 p, Vec3 d, const Nappe& nappe) {
    const double moved = -dot(p, d);
    const Vec3 q = p + moved * d;
    const double x = q.x, z = q.z, r = nappe.slope * (nappe.height - q.y) + nappe.radius;
    const double dr = nappe.slope * -d.y;

    const double a = d.x * d.x + d.z * d.z - dr * dr;
    const double b = x * d.x + z * d.z - r * dr;
    const double c = x * x + z * z - r * r;
    const double xr = x * dr - r * d.x, zr = z * dr - r * d.z, xz = x * d.z - z * d.x;
    const double discriminant = xr * xr + zr * zr - xz * xz;

    if (a == 0) { // parallel to a generator: one root, and the solid beyond it
        if (b < 0 && dr > 0) return {moved - c / (2 * b), Bounds::infinity};
        if (b > 0 && dr < 0) return {-Bounds::infinity, moved - c / (2 * b)};
        // ... or, along a cylinder's axis, none: inside everywhere or nowhere.
        if (dr == 0 && c <= 0) return {-Bounds::infinity, Bounds::infinity};
        return {};
    }
    if (discriminant < 0 && a > 0) return {};
    const double h = std::sqrt(std::max(discriminant, 0.0));
    const double sum = -(b < 0 ? b - h : b + h);
    const double root1 = sum / a, root2 = sum != 0 ? c / sum : root1;
    const double low = std::min(root1, root2), high = std::max(root1, root2);
    if (a > 0) { // both roots on one nappe: ours if the middle of the chord has a positive radius
        const double middle = r - b / a * dr;
        return middle > 0 ? Stretch{moved + low, moved + high} : Stretch{};
    }
    // steeper than a generator: one root on each nappe, and the radius grows towards ours
    return dr > 0 ? Stretch{moved + high, Bounds::infinity} : Stretch{-Bounds::infinity, moved + low};
}

/// The outward normal at a local point of the surface: radial, tilted up by the slope. At the apex, the axis.
inline Vec3 nappeNormal(Vec3 p, const Nappe& nappe) {
    const double distance = std::sqrt(p.x * p.x + p.z * p.z);
    if (distance == 0) return {0, 1, 0};
    return normalised({p.x / distance, nappe.slope, p.z / distance});
}

} // namespace yarte::trace
