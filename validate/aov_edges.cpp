#include "validate/aov_edges.h"

#include <algorithm>

namespace yarte::validate {

namespace {

/// Calls `visit(p, q)` for the pixel p and each of its neighbours q.
template <class Visit>
void forNeighbours(const Aov& aov, std::size_t p, Visit visit) {
    const int width = aov.width, x = static_cast<int>(p) % width, y = static_cast<int>(p) / width;
    for (int v = std::max(0, y - 1); v <= std::min(aov.height - 1, y + 1); ++v)
        for (int u = std::max(0, x - 1); u <= std::min(width - 1, x + 1); ++u)
            visit(static_cast<std::size_t>(v) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(u));
}

} // namespace

AovEdges edgesOf(const Aov& aov) {
    AovEdges edges;
    for (std::vector<bool>* mask : {&edges.outline, &edges.shadow, &edges.mirrored, &edges.seen})
        mask->resize(aov.size());
    for (std::size_t p = 0; p < aov.size(); ++p)
        forNeighbours(aov, p, [&](std::size_t q) {
            if (aov.body[p] != aov.body[q]) {
                edges.outline[p] = true;
                return;
            }
            if (!aov.shadowedLights.same(p, q)) edges.shadow[p] = true;
            if (aov.reflectedBody[p] != aov.reflectedBody[q]) edges.mirrored[p] = true;
            if (aov.transmittedBody[p] != aov.transmittedBody[q]) edges.seen[p] = true;
        });
    return edges;
}

std::vector<bool> nearOutline(const Aov& aov, int distance) {
    std::vector<bool> mask(aov.size());
    if (distance < 1) return mask;
    mask = edgesOf(aov).outline;
    for (int step = 1; step < distance; ++step) {
        std::vector<bool> wider = mask;
        for (std::size_t p = 0; p < aov.size(); ++p)
            if (mask[p]) forNeighbours(aov, p, [&](std::size_t q) { wider[q] = true; });
        mask = std::move(wider);
    }
    return mask;
}

} // namespace yarte::validate
