// Nappe: the solid x^2 + z^2 <= (slope w)^2, w >= 0, where w is the depth below the apex: what cones are cut
// from.
#pragma once

#include "yarte/trace/bounds.h"

namespace yarte::trace {

/// The stretch of a line inside a convex solid; empty where from > to; an end may be infinite.
struct Stretch {
    double from = Bounds::infinity, to = -Bounds::infinity;
    bool empty() const { return !(from <= to); }
};

/// Where the line p + t d is inside the nappe. `p` is relative to the base centre, whose apex is at y =
/// height; `d` has unit length.
///
/// With the form M = diag(1, 1, -slope^2) over (x, z, w), the surface is (p + t d)' M (p + t d) = 0:
/// a t^2 + 2 b t + c. b^2 - a c cancels badly; by Lagrange's identity it is
/// slope^2 ((x dw - w dx)^2 + (z dw - w dz)^2) - (x dz - z dx)^2. The origin is first moved to the point of
/// the line nearest to the base centre, so that a distant one loses nothing.
inline Stretch stretchInNappe(Vec3 p, Vec3 d, double slope, double height) {
    const double moved = -dot(p, d);
    const Vec3 q = p + moved * d;
    const double x = q.x, z = q.z, w = height - q.y, dw = -d.y;
    const double slope2 = slope * slope;

    const double a = d.x * d.x + d.z * d.z - slope2 * dw * dw;
    const double b = x * d.x + z * d.z - slope2 * w * dw;
    const double c = x * x + z * z - slope2 * w * w;
    const double xw = x * dw - w * d.x, zw = z * dw - w * d.z, xz = x * d.z - z * d.x;
    const double discriminant = slope2 * (xw * xw + zw * zw) - xz * xz;

    if (a == 0) { // parallel to a generator: one root, and the solid beyond it
        if (b < 0 && dw > 0) return {moved - c / (2 * b), Bounds::infinity};
        if (b > 0 && dw < 0) return {-Bounds::infinity, moved - c / (2 * b)};
        return {};
    }
    if (discriminant < 0 && a > 0) return {};
    const double h = std::sqrt(std::max(discriminant, 0.0));
    const double sum = -(b < 0 ? b - h : b + h);
    const double root1 = sum / a, root2 = sum != 0 ? c / sum : root1;
    const double low = std::min(root1, root2), high = std::max(root1, root2);
    if (a > 0) { // both roots on one nappe: ours if the middle of the chord lies below the apex
        const double depth = w - b / a * dw;
        return depth > 0 ? Stretch{moved + low, moved + high} : Stretch{};
    }
    // steeper than a generator: one root on each nappe, and w grows towards ours
    return dw > 0 ? Stretch{moved + high, Bounds::infinity} : Stretch{-Bounds::infinity, moved + low};
}

/// The outward normal at a local point of the surface: radial, tilted up by the slope. At the apex, the axis.
inline Vec3 nappeNormal(Vec3 p, double slope) {
    const double distance = std::sqrt(p.x * p.x + p.z * p.z);
    if (distance == 0) return {0, 1, 0};
    return normalised({p.x / distance, slope, p.z / distance});
}

} // namespace yarte::trace
