#include "yarte/trace/phong.h"

#include "yarte/trace/power.h"

#include <cmath>

namespace yarte::trace {

SurfacePoint surfacePoint(const World& world, const Ray& ray, const Hit& hit) {
    const Vec3 position = ray.at(hit.t);
    const Vec3 outward =
        world.visit(hit.element, [&](const auto& shape) { return outwardNormal(shape, position, hit.part); });
    const bool isBack = dot(ray.direction, outward) > 0;
    return {position, isBack ? -outward : outward, isBack, hit.element,
            hit.entering ? Side::outside : Side::inside};
}

Colour localColour(const World& world, const SurfacePoint& point, Vec3 mirrorDirection,
                   std::uint64_t& shadowRays) {
    const BodyAppearance& body = world.appearanceOf(point.element);
    Colour sum = body.ambient[point.isBack];
    const Colour diffuse = body.diffuse[point.isBack], specular = body.specular[point.isBack];
    if (isBlack(diffuse) && isBlack(specular)) return sum;
    for (const Light& light : world.lights) {
        const Vec3 toLight = light.position - point.position;
        const double distance = length(toLight);
        const Vec3 direction = toLight / distance;
        const double cosine = dot(point.normal, direction);
        if (!(cosine > 0)) continue; // also where the light lies on the point itself
        ++shadowRays;
        const Colour arriving =
            transmittance(world, {point.position, direction, {point.element, point.viewerSide}}, distance);
        if (isBlack(arriving)) continue;
        const double highlight = dot(mirrorDirection, direction);
        Colour reflected = diffuse * cosine;
        if (highlight > 0) reflected += specular * power(highlight, body.exponent);
        sum += light.brightness * arriving * reflected;
    }
    return sum;
}

} // namespace yarte::trace
