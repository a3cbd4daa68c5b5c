#include "convert/gltf/geometry_print.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>

namespace yarte::convert::gltf {
namespace {

using Bits = std::array<std::uint32_t, 3>;

Bits bitsOf(const GeometryPrint::Corner& corner) {
    Bits bits;
    // Adding 0 makes -0 to 0.
    std::ranges::transform(corner, bits.begin(),
                           [](float c) { return std::bit_cast<std::uint32_t>(c + 0.0F); });
    return bits;
}

/// The finaliser of splitmix64 [Steele14]: every bit of the result depends on every bit of `x`.
constexpr std::uint64_t mixed(std::uint64_t x) {
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9;
    x = (x ^ (x >> 27)) * 0x94d049bb133111eb;
    return x ^ (x >> 31);
}

} // namespace

void GeometryPrint::add(const Corner& a, const Corner& b, const Corner& c) {
    std::array<Bits, 3> corners{bitsOf(a), bitsOf(b), bitsOf(c)};
    if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) return;
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    std::uint64_t hash = 0;
    for (const Bits& corner : corners)
        for (const std::uint32_t bits : corner) hash = mixed(hash + 0x9e3779b97f4a7c15 + bits);
    sum_ += hash; // a sum has no order
    ++count_;
    for (const Corner* corner : {&a, &b, &c})
        for (const float value : *corner) reach_ = std::max(reach_, static_cast<double>(std::abs(value)));
}

std::string GeometryPrint::text() const { return fmt::format("{}-{:016x}", count_, sum_); }

} // namespace yarte::convert::gltf
