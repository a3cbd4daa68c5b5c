#include "convert/gltf/write_view.h"

#include "convert/gltf/exact_store.h"
#include "convert/gltf/light_map.h"
#include "convert/gltf/write_node.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace yarte::convert::gltf {
namespace {

/// glTF's cameras look along -z, their top is +y.
Frame cameraAxes(const Camera& camera) {
    const Vec3 back = unitVector(camera.position - camera.focus);
    const Vec3 right = unitVector(cross(unitVector(camera.up), back));
    return {right, cross(back, right), back};
}

} // namespace

std::size_t writeCamera(const Camera& camera, const std::optional<Extent>& extent, Output& output) {
    constexpr double toRadians = std::numbers::pi / 180;
    const double vertical = camera.verticalApertureDegrees * toRadians,
                 horizontal = camera.horizontalApertureDegrees * toRadians;
    const double yfov = 2 * vertical, aspectRatio = std::tan(horizontal) / std::tan(vertical);
    // Viewers need a nearest distance; YARTE has none.
    const double distance = extent ? length(extent->centre() - camera.position) + extent->halfDiagonal() : 0;
    const double znear = distance > 0 && std::isfinite(distance) ? 1e-3 * distance : 1e-3;
    const std::size_t index =
        output.add("cameras", object({{"type", json("perspective")},
                                      {"perspective", object({{"yfov", json(yfov)},
                                                              {"aspectRatio", json(aspectRatio)},
                                                              {"znear", json(znear)}})}}));
    const Frame axes = cameraAxes(camera);
    Json node = object({{"name", json("camera")}, {"camera", json(index)}});
    setTransform(node, axes, 1, camera.position);
    set(node, "extras", extrasOf(camera, {axes.x, axes.y, axes.z, camera.position}, yfov, aspectRatio));
    return output.add("nodes", std::move(node));
}

double intensityOf(const Light& light, const std::optional<Extent>& extent) {
    double distance = extent ? length(light.position - extent->centre()) : 1;
    if (distance == 0) distance = extent->halfDiagonal(); // within the bodies
    const double brightness = maxComponent(light.brightness);
    if (brightness == 0) return 0;
    // JSON has no infinity, which the square of a very large distance is.
    const double candela = candelaOfBrightness(brightness, distance);
    return std::isfinite(candela) ? candela : std::numeric_limits<double>::max();
}

std::vector<std::size_t> writeLights(const std::vector<Light>& lights, const std::optional<Extent>& extent,
                                     Output& output) {
    constexpr const char* extension = "KHR_lights_punctual";
    std::vector<std::size_t> nodes;
    for (std::size_t i = 0; i < lights.size(); ++i) {
        const Light& light = lights[i];
        const Colour brightness = light.brightness;
        const ShownLight shown{isBlack(brightness) ? Colour{1, 1, 1}
                                                   : brightness * (1 / maxComponent(brightness)),
                               intensityOf(light, extent)};
        const std::string name = fmt::format("light {}", i + 1);
        const std::size_t index = output.add(extension, "lights",
                                             object({{"type", json("point")},
                                                     {"name", json(name)},
                                                     {"color", json(shown.colour)},
                                                     {"intensity", json(shown.intensity)}}));
        Json node = object({{"name", json(name)}});
        setTransform(node, {}, 1, light.position);
        set(node, "extensions", object({{extension, object({{"light", json(index)}})}}));
        set(node, "extras", extrasOf(light, i, shown));
        nodes.push_back(output.add("nodes", std::move(node)));
    }
    return nodes;
}

} // namespace yarte::convert::gltf
