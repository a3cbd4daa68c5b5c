#include "convert/closed_mesh.h"

#include <algorithm>
#include <utility>

namespace yarte::convert {

bool isClosed(const MeshData& mesh) {
    using Edge = std::pair<std::uint32_t, std::uint32_t>;
    std::vector<Edge> edges, reversed;
    for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
        const auto face = mesh.face(f);
        for (std::size_t i = 0; i < face.size(); ++i) {
            const std::uint32_t from = face[i], to = face[(i + 1) % face.size()];
            edges.emplace_back(from, to), reversed.emplace_back(to, from);
        }
    }
    std::ranges::sort(edges), std::ranges::sort(reversed);
    return edges == reversed && std::ranges::adjacent_find(edges) == edges.end();
}

} // namespace yarte::convert
