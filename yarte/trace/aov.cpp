#include "yarte/trace/aov.h"

#include "yarte/trace/media.h"
#include "yarte/trace/phong.h"
#include "yarte/trace/power.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace yarte {
namespace trace {
namespace {

/// Whitted's recursion as a recursion, which keeps apart what `Whitted` adds up.
class Walk {
public:
    Walk(const World& world, std::span<const Light> lights, AovPixel& pixel)
        : world_(world), lights_(lights), pixel_(pixel) {}

    void fromCamera(const Ray& ray);

private:
    struct Path {
        Colour weight{1, 1, 1}; ///< black: nothing of it arrives in the pixel
        int levelsLeft = 0;
        MediaStack media;
    };

    /// The colour that the ray brings, not weighted.
    Colour follow(const Ray&, const Path&);
    Colour beyond(const Ray&, const Path&, const SurfacePoint&, Vec3 mirror, bool isCamera);
    Colour local(const SurfacePoint&, Vec3 mirror, Colour weight);
    AovVisit& visitOf(const SurfacePoint&);
    AovLight lightAt(const SurfacePoint&, Vec3 mirror, const Light&);
    void recordCasters(const Ray& toLight, double distance);
    int bodyMetBy(const Ray& ray) const {
        const auto hit = nearestHit(world_, ray);
        return hit ? static_cast<int>(world_.bodyOf(hit->element).index) : -1;
    }

    const World& world_;
    std::span<const Light> lights_; ///< the scene's, dark ones included: the world has only what shines
    AovPixel& pixel_;
};

AovLight Walk::lightAt(const SurfacePoint& point, Vec3 mirror, const Light& light) {
    const Vec3 toLight = light.position - point.position;
    const double distance = length(toLight);
    const Vec3 direction = toLight / distance;
    const double cosine = dot(point.normal, direction);
    if (!(cosine > 0)) return {};
    const Ray ray{point.position, direction, {point.element, point.viewerSide}};
    return {transmittance(world_, ray, distance), cosine, std::max(0.0, dot(mirror, direction))};
}

void Walk::recordCasters(const Ray& toLight, double distance) {
    Ray ray = toLight;
    for (auto hit = nearestHit(world_, ray); hit && hit->t < distance; hit = nearestHit(world_, ray)) {
        pixel_.casting[world_.bodyOf(hit->element).index] = true;
        distance -= hit->t;
        ray = {ray.at(hit->t), ray.direction, {hit->element, hit->entering ? Side::inside : Side::outside}};
    }
}

AovVisit& Walk::visitOf(const SurfacePoint& point) {
    const BodyAppearance& a = world_.appearanceOf(point.element);
    const bool sidesDiffer =
        a.ambient[0] != a.ambient[1] || a.diffuse[0] != a.diffuse[1] || a.specular[0] != a.specular[1];
    const int body = static_cast<int>(world_.bodyOf(point.element).index);
    const bool isBack = sidesDiffer && point.isBack;
    for (AovVisit& visit : pixel_.visits)
        if (visit.body == body && visit.isBack == isBack) return visit;
    return pixel_.visits.emplace_back(AovVisit{body, isBack, {}, {}, {}, {}, {}});
}

Colour Walk::local(const SurfacePoint& point, Vec3 mirror, Colour weight) {
    const BodyAppearance& body = world_.appearanceOf(point.element);
    Colour lit, highlight, sum = body.ambient[point.isBack];
    for (std::size_t i = 0; i < lights_.size(); ++i) {
        const Light& light = lights_[i];
        const AovLight at = lightAt(point, mirror, light);
        if (at.lambert == 0) continue;
        if (!isBlack(weight)) {
            const Vec3 toLight = light.position - point.position;
            recordCasters({point.position, normalised(toLight), {point.element, point.viewerSide}},
                          length(toLight));
        }
        const double phong = at.mirror > 0 ? power(at.mirror, body.exponent) : 0;
        const Colour diffuse = light.brightness * at.arriving * at.lambert,
                     specular = light.brightness * at.arriving * phong,
                     share = body.diffuse[point.isBack] * diffuse + body.specular[point.isBack] * specular;
        lit += diffuse, highlight += specular, sum += share;
        pixel_.lightShare[i] += weight * share;
    }
    if (!isBlack(weight)) {
        AovVisit& visit = visitOf(point);
        visit.weight += weight, visit.lit += weight * lit, visit.highlight += weight * highlight;
    }
    return sum;
}

Colour Walk::beyond(const Ray& ray, const Path& path, const SurfacePoint& point, Vec3 mirror, bool isCamera) {
    if (path.levelsLeft == 0) return {};
    const BodyAppearance& body = world_.appearanceOf(point.element);
    Colour sum;
    if (body.reflection > 0 || !isBlack(path.weight)) {
        const Ray next{point.position, mirror, {point.element, point.viewerSide}};
        const Colour brought = follow(next, {path.weight * body.reflection, path.levelsLeft - 1, path.media});
        sum += body.reflection * brought;
        if (!isBlack(path.weight)) visitOf(point).reflected += path.weight * brought;
        if (isCamera && body.reflection > 0) pixel_.reflectedBody = bodyMetBy(next);
    }
    if (!isBlack(body.transmission)) {
        Transmission onward = transmit(world_, path.media, world_.bodyOf(point.element), ray.direction,
                                       point.normal, mirror, point.viewerSide);
        const Ray next{point.position, onward.direction, {point.element, onward.side}};
        const double ct = body.totalReflection;
        const Colour passes = onward.isReflected ? Colour{ct, ct, ct} : body.transmission;
        const Colour brought =
            follow(next, {path.weight * passes, path.levelsLeft - (onward.isContinued ? 0 : 1),
                          std::move(onward.media)});
        sum += passes * brought;
        if (!isBlack(path.weight)) visitOf(point).transmitted += path.weight * passes * brought * (1 / ct);
        if (isCamera) pixel_.transmittedBody = bodyMetBy(next);
    }
    return sum;
}

Colour Walk::follow(const Ray& ray, const Path& path) {
    const auto hit = nearestHit(world_, ray);
    if (!hit) {
        pixel_.backgroundWeight += path.weight;
        return world_.background;
    }
    const SurfacePoint point = surfacePoint(world_, ray, *hit);
    if (!isBlack(path.weight)) pixel_.secondary[world_.bodyOf(point.element).index] = true;
    const Vec3 mirror = mirrored(ray.direction, point.normal);
    return local(point, mirror, path.weight) + beyond(ray, path, point, mirror, false);
}

void Walk::fromCamera(const Ray& ray) {
    const auto hit = nearestHit(world_, ray);
    if (!hit) {
        pixel_.backgroundWeight = {1, 1, 1};
        return;
    }
    const SurfacePoint point = surfacePoint(world_, ray, *hit);
    pixel_.body = static_cast<int>(world_.bodyOf(point.element).index);
    pixel_.depth = hit->t;
    pixel_.normal = point.normal;
    pixel_.isBack = point.isBack;
    const Vec3 mirror = mirrored(ray.direction, point.normal);
    for (std::size_t i = 0; i < lights_.size(); ++i) pixel_.lights[i] = lightAt(point, mirror, lights_[i]);
    local(point, mirror, {1, 1, 1});
    beyond(ray, {{1, 1, 1}, world_.levels, world_.cameraMedia}, point, mirror, true);
}

} // namespace
} // namespace trace

AovPixel aovPixel(const World& world, std::span<const Light> lights, int x, int y) {
    AovPixel pixel;
    pixel.lights.resize(lights.size());
    pixel.lightShare.resize(lights.size());
    pixel.secondary.resize(world.bodies.size());
    pixel.casting.resize(world.bodies.size());
    trace::Walk(world, lights, pixel).fromCamera(world.camera.through(x, y));
    std::stable_sort(pixel.visits.begin(), pixel.visits.end(), [](const AovVisit& a, const AovVisit& b) {
        return maxComponent(a.weight) > maxComponent(b.weight);
    });
    return pixel;
}

} // namespace yarte
