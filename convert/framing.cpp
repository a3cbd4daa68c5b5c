#include "convert/framing.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace yarte::convert {
namespace {

constexpr double halfAngleDegrees = 20;

/// At which a camera of that aperture sees the whole ball.
double distanceTo(const Ball& ball) {
    constexpr double margin = 1.1;
    return margin * ball.radius / std::sin(halfAngleDegrees * std::numbers::pi / 180);
}

/// Around the centre of the bounding box.
Ball ballAround(const std::vector<Vec3>& points) {
    if (points.empty()) return {};
    Vec3 low = points.front(), high = low;
    for (const Vec3 p : points) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
    const double radius = length(high - low) / 2;
    return {low + (high - low) / 2, radius > 0 ? radius : 1};
}

} // namespace

void addCamera(Scene& scene, const Ball& ball, Ledger& ledger) {
    scene.camera.focus = ball.centre;
    scene.camera.position = ball.centre + normalised({0.4, 0.5, 1}) * distanceTo(ball);
    scene.camera.horizontalApertureDegrees = scene.camera.verticalApertureDegrees = halfAngleDegrees;
    ledger.add({"camera", "everything", Action::added, "sees all of it", {}});
}

void addLight(Scene& scene, const Ball& ball, Ledger& ledger) {
    scene.lights.push_back({ball.centre + normalised({-1, 2, 1.5}) * distanceTo(ball), {1, 1, 1}});
    ledger.add({"light 1", "everything", Action::added, "white, above the camera", {}});
}

Scene sceneAround(MeshData mesh, Ledger& ledger) {
    const Ball ball = ballAround(mesh.vertices);
    Scene scene;
    addCamera(scene, ball, ledger);
    addLight(scene, ball, ledger);
    scene.materials.push_back({{0.1, 0.1, 0.1}, {0.7, 0.7, 0.7}, {0.2, 0.2, 0.2}, 20, 0, 0, 0});
    scene.meshes.push_back(std::move(mesh));
    Body body{.shape = Mesh{}, .material = {}, .referential = {}, .back = {}};
    std::get<Mesh>(body.shape).axes.z = Vec3{0, 0, 1};
    scene.bodies.push_back(std::move(body));

    ledger.add({"material 1", "everything", Action::added, "grey", {}});
    return scene;
}

} // namespace yarte::convert
