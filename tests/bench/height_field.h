// A large mesh for benchmarks: a wavy surface over a square.
#pragma once

#include "yarte/scene/mesh_data.h"

#include <cmath>

namespace yarte::bench {

/// 2 side^2 triangles with coordinates that floats hold: the surface of height_field.py.
inline MeshData heightField(int side) {
    MeshData mesh;
    for (int j = 0; j <= side; ++j)
        for (int i = 0; i <= side; ++i) {
            const double x = 2.0 * i / side - 1, z = 2.0 * j / side - 1;
            const double y =
                0.15 * std::sin(9 * x) * std::cos(7 * z) + 0.02 * std::sin(61 * x + 3 * z) * std::sin(53 * z);
            const auto rounded = [](double v) { return double{static_cast<float>(v)}; };
            mesh.vertices.push_back({rounded(x), rounded(y), rounded(z)});
        }
    const auto row = static_cast<std::uint32_t>(side + 1);
    for (std::uint32_t j = 0; j + 1 < row; ++j)
        for (std::uint32_t a = j * row; a + 1 < (j + 1) * row; ++a)
            for (const std::uint32_t corner : {a, a + row, a + 1, a + 1, a + row, a + row + 1})
                mesh.corners.push_back(corner);
    for (std::uint32_t end = 3; end <= mesh.corners.size(); end += 3) mesh.faceStarts.push_back(end);
    return mesh;
}

} // namespace yarte::bench
