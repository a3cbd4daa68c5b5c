#include "yarte/trace/whitted.h"

#include <iterator>
#include <utility>

namespace yarte::trace {

Colour Whitted::colour(const Ray& cameraRay, RayCounts& counts) {
    ++counts.camera;
    Colour sum;
    current_.clear();
    current_.push_back({cameraRay, {1, 1, 1}, world_.levels, world_.cameraMedia});
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
        if (!isBlack(body.transmission)) transmit(pending, point, mirror, counts);
    }
    return localColour(world_, point, mirror, counts.shadow);
}

void Whitted::transmit(const Pending& pending, const SurfacePoint& point, Vec3 mirror, RayCounts& counts) {
    const BodyAppearance& body = world_.appearanceOf(point.element);
    Transmission next = trace::transmit(world_, pending.media, world_.bodyOf(point.element),
                                        pending.ray.direction, point.normal, mirror, point.viewerSide);
    ++(next.isReflected ? counts.reflected : counts.transmitted);
    transmitted_.push_back(
        {{point.position, next.direction, {point.element, next.side}},
         next.isReflected ? pending.weight * body.totalReflection : pending.weight * body.transmission,
         pending.levelsLeft - (next.isContinued ? 0 : 1),
         std::move(next.media)});
}

} // namespace yarte::trace
