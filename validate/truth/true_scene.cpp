#include "validate/truth/true_scene.h"

#include "yarte/scene/mesh_placement.h"
#include "yarte/scene/referential.h"

#include <boost/math/constants/constants.hpp>

#include <utility>
#include <variant>

namespace yarte::validate {

namespace {

/// What could be met, with room for the rounding of this test itself.
bool mayMeet(const Ball& ball, Vec3 origin, Vec3 direction) {
    if (ball.isUnbounded) return true;
    const Vec3 toCentre = ball.centre - origin;
    const double along = dot(toCentre, direction), slack = 1e-6 * (ball.radius + length(toCentre));
    const double radius = ball.radius + slack;
    const Vec3 aside = toCentre - direction * along;
    return along >= -radius && dot(aside, aside) <= radius * radius;
}

/// Normals as equal as this make a flat face (yarte/LANGUAGE.md).
bool areEqual(const std::vector<RealVec3>& normals) {
    const Real tolerance("1e-5");
    for (const RealVec3& n : normals) {
        const RealVec3 d = n - normals[0];
        if (abs(d.x) > tolerance || abs(d.y) > tolerance || abs(d.z) > tolerance) return false;
    }
    return true;
}

FaceSurface faceOf(const Polygon& polygon) {
    return {{polygon.vertices.begin(), polygon.vertices.end()}, {}};
}

FaceSurface faceOf(const Mesh& mesh, const MeshData& data, std::size_t face) {
    const Frame axes = resolveReferential(mesh.axes);
    const auto turned = [&](const RealVec3& v) {
        return RealVec3(axes.x) * v.x + RealVec3(axes.y) * v.y + RealVec3(axes.z) * v.z;
    };
    FaceSurface surface;
    for (const std::uint32_t corner : data.face(face))
        surface.vertices.push_back(turned(RealVec3(data.vertices[corner]) * mesh.scale) + mesh.translation);
    if (!data.isSmooth()) return surface;
    for (const std::uint32_t normal : data.faceNormals(face))
        surface.normals.push_back(normalised(turned(data.normals[normal])));
    if (areEqual(surface.normals)) surface.normals.clear();
    return surface;
}

ShapeSurface surfaceOf(const Body& body) {
    const Frame axes = body.referential ? resolveReferential(*body.referential) : Frame{};
    return {body.shape, {axes.x, axes.y, axes.z}};
}

} // namespace

std::size_t surfaceCount(const Scene& scene) {
    std::size_t count = 0;
    for (const Body& body : scene.bodies) {
        const auto* mesh = std::get_if<Mesh>(&body.shape);
        count += mesh ? scene.meshes[mesh->mesh.index].faceCount() : 1;
    }
    return count;
}

TrueScene::TrueScene(Scene scene, Resolution resolution) : scene_(std::move(scene)), resolution_(resolution) {
    const Camera& camera = scene_.camera;
    const auto tangent = [](double degrees) {
        return tan(Real(degrees) * boost::math::constants::pi<Real>() / 180);
    };
    eye_ = camera.position;
    forward_ = normalised(RealVec3(camera.focus) - eye_);
    const RealVec3 right = normalised(cross(forward_, camera.up));
    right_ = right * (2 * tangent(camera.horizontalApertureDegrees));
    up_ = cross(right, forward_) * (2 * tangent(camera.verticalApertureDegrees));
    surfaces_.reserve(surfaceCount(scene_));
    for (std::size_t body = 0; body < scene_.bodies.size(); ++body) addBody(body);
}

void TrueScene::addBody(std::size_t body) {
    const Shape& shape = scene_.bodies[body].shape;
    if (const auto* polygon = std::get_if<Polygon>(&shape)) {
        surfaces_.push_back({ballAround(polygon->vertices), body, 0});
    } else if (const auto* mesh = std::get_if<Mesh>(&shape)) {
        const MeshData& data = scene_.meshes[mesh->mesh.index];
        const std::vector<Vec3> placed = placedVertices(data, *mesh);
        for (std::size_t face = 0; face < data.faceCount(); ++face) {
            std::vector<Vec3> vertices;
            for (const std::uint32_t corner : data.face(face)) vertices.push_back(placed[corner]);
            surfaces_.push_back({ballAround(vertices), body, face});
        }
    } else {
        surfaces_.push_back({ballAround(surfaceOf(scene_.bodies[body])), body, 0});
    }
}

RealRay TrueScene::ray(int x, int y) const {
    const Real u = (Real(x) + 0.5) / resolution_.width - 0.5, v = 0.5 - (Real(y) + 0.5) / resolution_.height;
    return {eye_, normalised(forward_ + right_ * u + up_ * v)};
}

std::optional<SurfaceHit> TrueScene::hit(const Surface& surface, const RealRay& ray) const {
    const Body& body = scene_.bodies[surface.body];
    if (const auto* polygon = std::get_if<Polygon>(&body.shape))
        return validate::firstHit(faceOf(*polygon), ray);
    if (const auto* mesh = std::get_if<Mesh>(&body.shape))
        return validate::firstHit(faceOf(*mesh, scene_.meshes[mesh->mesh.index], surface.face), ray);
    return validate::firstHit(surfaceOf(body), ray);
}

std::optional<TrueHit> TrueScene::firstHit(const RealRay& ray) const {
    const Vec3 origin = ray.origin.rounded(), direction = ray.direction.rounded();
    std::optional<TrueHit> nearest;
    for (const Surface& surface : surfaces_) {
        if (!mayMeet(surface.ball, origin, direction)) continue;
        const auto met = hit(surface, ray);
        if (met && (!nearest || met->distance < nearest->distance))
            nearest = TrueHit{static_cast<int>(surface.body), met->distance, met->normal};
    }
    return nearest;
}

} // namespace yarte::validate
