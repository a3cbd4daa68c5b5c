#include "yarte/trace/search.h"

#include <algorithm>
#include <vector>

namespace yarte::trace {
namespace {

/// Calls `visit` for the element's crossings with the ray ahead of its start.
template <class Shape, class Visit>
void visitCrossings(const Shape& shape, const Ray& ray, bool departs, Visit&& visit) {
    if (!departs) {
        for (const Crossing& c : crossings(shape, ray))
            if (c.t > 0) visit(c);
        return;
    }
    // The ray starts on this very surface. Outside a convex one there is nothing more to meet ...
    if (Shape::isFlat || ray.from.side == Side::outside) return;
    // ... and inside only its far end, which a closed one always has, however close to the start rounding
    // puts it. That is not in doubt; that the start is next to the surface is known.
    for (const Crossing& c : quickCrossings(shape, ray)) {
        if (c.entering) continue;
        if (Shape::isClosed) return visit(Crossing{std::max(c.t, 0.0), c.part, false});
        if (c.t > 0) visit(c);
        return;
    }
    if (Shape::isClosed) visit(Crossing{0, 0, false});
}

/// `forEach(tMax, visit)` visits candidate elements; see traverse.
template <class ForEach>
std::optional<Hit> nearest(const World& world, const Ray& ray, ForEach&& forEach) {
    double tMax = Bounds::infinity;
    Hit best{Bounds::infinity, {}, 0, false};
    forEach(tMax, [&](ElementId element) {
        world.visit(element, [&](const auto& shape) {
            visitCrossings(shape, ray, element == ray.from.element, [&](const Crossing& c) {
                if (c.t > best.t || (c.t == best.t && element.index >= best.element.index)) return;
                best = {c.t, element, c.part, c.entering};
                tMax = c.t;
            });
        });
        return false;
    });
    if (best.t == Bounds::infinity) return std::nullopt;
    return best;
}

template <class ForEach>
Colour throughput(const World& world, const Ray& ray, double distance, ForEach&& forEach) {
    double tMax = distance;
    bool isBlocked = false;
    // Stays empty, and allocates nothing, unless light passes through something.
    std::vector<std::uint32_t> levels;
    forEach(tMax, [&](ElementId element) {
        const BodyAppearance& body = world.appearanceOf(element);
        world.visit(element, [&](const auto& shape) {
            visitCrossings(shape, ray, element == ray.from.element, [&](const Crossing& c) {
                if (c.t >= distance) return;
                if (isBlack(body.transmission))
                    isBlocked = true;
                else
                    levels.push_back(body.transmissionLevel);
            });
        });
        return isBlocked;
    });
    if (isBlocked) return {};
    // Multiplied in the order of the levels, so that the order of the search cannot show in the last bit.
    std::sort(levels.begin(), levels.end());
    Colour product{1, 1, 1};
    for (const std::uint32_t level : levels) product = product * world.transmissions[level];
    return product;
}

auto allElements(const World& world) {
    return [&world](double&, auto&& visit) {
        for (std::uint32_t i = 0; i < world.elements.size(); ++i)
            if (visit(ElementId{i})) return;
    };
}

auto treeElements(const World& world, const Ray& ray) {
    return [&world, &ray](double& tMax, auto&& visit) {
        for (const ElementId element : world.unbounded)
            if (visit(element)) return;
        traverse(world.tree, ray, tMax, visit);
    };
}

} // namespace

std::optional<Hit> nearestHitBrute(const World& world, const Ray& ray) {
    return nearest(world, ray, allElements(world));
}

Colour transmittanceBrute(const World& world, const Ray& ray, double distance) {
    return throughput(world, ray, distance, allElements(world));
}

std::optional<Hit> nearestHit(const World& world, const Ray& ray) {
    return world.tree.empty() ? nearestHitBrute(world, ray) : nearest(world, ray, treeElements(world, ray));
}

Colour transmittance(const World& world, const Ray& ray, double distance) {
    return world.tree.empty() ? transmittanceBrute(world, ray, distance)
                              : throughput(world, ray, distance, treeElements(world, ray));
}

} // namespace yarte::trace
