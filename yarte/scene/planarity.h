// How far from planar a face is (SCENE-LANGUAGE decision D9).
#pragma once

#include "yarte/base/vec3.h"

#include <cstddef>
#include <optional>
#include <span>

namespace yarte {

/// A vertex farther than this from the plane is an error, as a part of the face's size.
inline constexpr double maxPlanarityError = 1e-3;
/// A face whose area is at most this part of its size squared has none: no normal can be trusted.
inline constexpr double minRelativeArea = 1e-12;

struct Planarity {
    double error = 0;       ///< distance of the farthest vertex from the plane, divided by the face's size
    std::size_t vertex = 0; ///< that vertex
};

/// Of a closed line of vertices: its plane passes through their mean with Newell's normal, its size is twice
/// the largest distance from the mean. Nothing for fewer than three vertices or without area.
std::optional<Planarity> planarity(std::span<const Vec3> vertices);

} // namespace yarte
