// Real: numbers of fifty decimal digits, and vectors of them. Beside a double's sixteen they are the truth.
#pragma once

#include "yarte/base/vec3.h"

#include <boost/multiprecision/cpp_bin_float.hpp>

namespace yarte::validate {

using Real =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_off>;

struct RealVec3 {
    Real x, y, z;

    RealVec3() = default;
    RealVec3(Real x_, Real y_, Real z_) : x(std::move(x_)), y(std::move(y_)), z(std::move(z_)) {}
    /// Exactly.
    RealVec3(Vec3 v) : x(v.x), y(v.y), z(v.z) {}

    Vec3 rounded() const { return {x.convert_to<double>(), y.convert_to<double>(), z.convert_to<double>()}; }
};

inline RealVec3 operator+(const RealVec3& a, const RealVec3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline RealVec3 operator-(const RealVec3& a, const RealVec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline RealVec3 operator-(const RealVec3& a) { return {-a.x, -a.y, -a.z}; }
inline RealVec3 operator*(const RealVec3& a, const Real& s) { return {a.x * s, a.y * s, a.z * s}; }
inline RealVec3 operator/(const RealVec3& a, const Real& s) { return {a.x / s, a.y / s, a.z / s}; }

inline Real dot(const RealVec3& a, const RealVec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline RealVec3 cross(const RealVec3& a, const RealVec3& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline Real length(const RealVec3& a) { return sqrt(dot(a, a)); }
inline RealVec3 normalised(const RealVec3& a) { return a / length(a); }

} // namespace yarte::validate
