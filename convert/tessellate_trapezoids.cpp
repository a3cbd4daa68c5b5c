#include "convert/tessellate_outline.h"

#include <algorithm>

namespace yarte::convert {
namespace {

struct Edge {
    std::uint32_t index;
    Point2 from, to;

    double low() const { return std::min(from.v, to.v); }
    double high() const { return std::max(from.v, to.v); }
    /// Where it is at the height v, which it reaches.
    double t(double v) const {
        if (v == from.v) return 0;
        if (v == to.v) return 1;
        return std::clamp((v - from.v) / (to.v - from.v), 0.0, 1.0);
    }
    double u(double v) const { return from.u + (to.u - from.u) * t(v); }
};

/// Level edges bound no trapezoid: its ends do.
std::vector<Edge> edgesOf(const std::vector<Point2>& outline) {
    std::vector<Edge> edges;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Edge edge{static_cast<std::uint32_t>(i), outline[i], outline[(i + 1) % outline.size()]};
        if (edge.low() < edge.high()) edges.push_back(edge);
    }
    return edges;
}

/// The heights of all vertices and crossings, in order.
std::vector<double> cutsOf(const std::vector<Edge>& edges) {
    std::vector<double> cuts;
    for (const Edge& edge : edges) cuts.insert(cuts.end(), {edge.low(), edge.high()});
    for (std::size_t i = 0; i < edges.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            const Edge &a = edges[i], &b = edges[j];
            const double low = std::max(a.low(), b.low()), high = std::min(a.high(), b.high());
            if (!(low < high)) continue;
            // Both are straight: they cross where their distance along u changes its sign.
            const double below = a.u(low) - b.u(low), above = a.u(high) - b.u(high);
            if ((below < 0) != (above < 0) && below != above)
                cuts.push_back(low + (high - low) * (below / (below - above)));
        }
    std::ranges::sort(cuts);
    cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
    return cuts;
}

} // namespace

std::vector<std::array<EdgePoint, 3>> cutIntoTrapezoids(const std::vector<Point2>& outline) {
    const std::vector<Edge> edges = edgesOf(outline);
    const std::vector<double> cuts = cutsOf(edges);
    std::vector<std::array<EdgePoint, 3>> triangles;
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
        const double low = cuts[i], high = cuts[i + 1], middle = low + (high - low) / 2;
        std::vector<const Edge*> across;
        for (const Edge& edge : edges)
            if (edge.low() <= low && high <= edge.high()) across.push_back(&edge);
        std::ranges::sort(across, {}, [&](const Edge* edge) { return edge->u(middle); });
        for (std::size_t k = 0; k + 1 < across.size(); k += 2) {
            const Edge &left = *across[k], &right = *across[k + 1];
            if (!(left.u(middle) < right.u(middle))) continue; // an edge there and back
            const EdgePoint a{left.index, left.t(low)}, b{right.index, right.t(low)},
                c{right.index, right.t(high)}, d{left.index, left.t(high)};
            if (left.u(low) < right.u(low)) triangles.push_back({a, b, c});
            if (left.u(high) < right.u(high)) triangles.push_back({a, c, d});
        }
    }
    return triangles;
}

} // namespace yarte::convert
