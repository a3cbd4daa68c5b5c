// The scalar type of the kernels. They are written once, for the type Scalar of the namespace that
// YARTE_PRECISION names; a translation unit defines it before it includes any of them, and each type's
// kernels lie in a namespace of their own.
#pragma once

#include <bit>
#include <cstdint>
#include <limits>

namespace yarte::trace {

namespace inDouble {

using Scalar = double;
inline constexpr bool isFloat = false;

/// Ids are kept in lanes as numbers in the same order, which compare and blend as all else does.
constexpr Scalar laneOf(std::uint32_t id) { return id; }
constexpr std::uint32_t idIn(Scalar lane) { return static_cast<std::uint32_t>(lane); }
inline constexpr Scalar noElement = laneOf(0xffffffff);

} // namespace inDouble

namespace inFloat {

using Scalar = float;
inline constexpr bool isFloat = true;

/// As in double, but floats hold integers to 2^24 only: an id counts the floats from the least normal one.
/// Good for 2^31 - 2^24 ids.
inline constexpr std::uint32_t firstBits = 0x00800000;
constexpr Scalar laneOf(std::uint32_t id) { return std::bit_cast<float>(firstBits + id); }
constexpr std::uint32_t idIn(Scalar lane) { return std::bit_cast<std::uint32_t>(lane) - firstBits; }
inline constexpr Scalar noElement = std::numeric_limits<float>::infinity();

} // namespace inFloat

} // namespace yarte::trace
