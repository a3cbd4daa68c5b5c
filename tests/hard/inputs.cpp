#include "tests/hard/inputs.h"

namespace yarte::hard {
namespace {

Vec<Real> exact(const Vec3& v) { return {v.x, v.y, v.z}; }

Vec<Real> unit(const Vec<Real>& v) { return v * Real(1 / boost::multiprecision::sqrt(dot(v, v))); }

} // namespace

Vec<Real> exactUnit(const Vec3& v) { return unit(exact(v)); }

Axes<Real> exactRotation(const Referential& r) {
    Axes<Real> a{exactUnit(r.x), exactUnit(r.y), {}};
    a.z = r.z && *r.z != Vec3{} ? exactUnit(*r.z) : unit(cross(a.x, a.y));
    // Quadratic: eight steps take axes 1e-3 off to far below 150 digits.
    for (int step = 0; step < 8; ++step) {
        const Vec<Real> yz = cross(a.y, a.z), zx = cross(a.z, a.x), xy = cross(a.x, a.y);
        const Real scale = 1 / dot(a.x, yz), half = 0.5;
        a = {(a.x + yz * scale) * half, (a.y + zx * scale) * half, (a.z + xy * scale) * half};
    }
    // What is exact in short numbers, as axes along the world's are, stays exact.
    const auto clean = [](Vec<Real> v) {
        for (Real* c : {&v.x, &v.y, &v.z}) {
            const Real rounded(static_cast<double>(*c));
            if (abs(*c - rounded) < Real("1e-140")) *c = rounded;
        }
        return v;
    };
    return {clean(a.x), clean(a.y), clean(a.z)};
}

} // namespace yarte::hard
