#include "yarte/trace/whitted.h"

#include <cmath>
#include <iterator>
#include <utility>

namespace yarte::trace {

Colour Whitted::colour(const Ray& cameraRay, RayCounts& counts) {
    ++counts.camera;
    Colour sum;
    current_.clear();
    current_.push_back({cameraRay, 1, world_.levels, world_.cameraMedia});
    while (!current_.empty()) {
        for (const Pending& pending : current_) sum += pending.weight * trace(pending, counts);
        current_.swap(reflected_);
        std::move(transmitted_.begin(), transmitted_.end(), std::back_inserter(current_));
        reflected_.clear(), transmitted_.clear();
    }
    return sum;
}

Colour Whitted::trace(const Pending& pending, RayCounts& counts) {
    const auto hit = nearestHit(world_, pending.ray);
    if (!hit) return world_.background;
    const SurfacePoint point = surfacePoint(world_, pending.ray, *hit);
    const BodyAppearance& body = world_.appearanceOf(point.element);
    const Vec3 mirror = mirrored(pending.ray.direction, point.normal);
    if (pending.levelsLeft > 0) {
        if (body.reflection > 0) {
            ++counts.reflected;
            reflected_.push_back({{point.position, mirror, {point.element, point.viewerSide}},
                                  pending.weight * body.reflection,
                                  pending.levelsLeft - 1,
                                  pending.media});
        }
        if (body.transmission > 0) transmit(pending, point, mirror, counts);
    }
    return localColour(world_, point, mirror, counts.shadow);
}

/// Snell's law in vector form: with k = 1 - ratio^2 (1 - cos^2), the refracted direction is
/// ratio d + (ratio cos - sqrt(k)) N [Heckbert89]; k < 0 is total reflection, which takes the transmitted
/// ray's weight.
void Whitted::transmit(const Pending& pending, const SurfacePoint& point, Vec3 mirror, RayCounts& counts) {
    const Vec3 direction = pending.ray.direction;
    Passage passage = pass(world_, pending.media, world_.bodyOf(point.element));
    Pending next{{point.position, direction, {point.element, opposite(point.viewerSide)}},
                 pending.weight * world_.appearanceOf(point.element).transmission,
                 pending.levelsLeft - 1,
                 {}};
    if (passage.isContinued) {
        next.levelsLeft = pending.levelsLeft;
    } else {
        const double cosine = -dot(direction, point.normal);
        const double k = 1 - passage.ratio * passage.ratio * (1 - cosine * cosine);
        if (k < 0) {
            ++counts.reflected;
            next.ray.direction = mirror;
            next.ray.from.side = point.viewerSide;
            next.media = pending.media;
            transmitted_.push_back(std::move(next));
            return;
        }
        next.ray.direction =
            normalised(passage.ratio * direction + (passage.ratio * cosine - std::sqrt(k)) * point.normal);
    }
    ++counts.transmitted;
    next.media = std::move(passage.after);
    transmitted_.push_back(std::move(next));
}

} // namespace yarte::trace
