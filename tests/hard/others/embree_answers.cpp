#include "tests/hard/others/embree_answers.h"

#include "yarte/scene/referential.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <memory>
#include <numeric>
#include <tuple>

namespace yarte::hard {
namespace {

/// Embree takes no others: their squares would overflow.
constexpr double largestCoordinate = 1e18;

double rounded(double x) { return static_cast<float>(x); }
Vec3 rounded(Vec3 v) { return {rounded(v.x), rounded(v.y), rounded(v.z)}; }

void fill(RTCGeometry geometry, RTCBufferType type, RTCFormat format, std::size_t floats, std::size_t count,
          std::initializer_list<double> values) {
    auto* to = static_cast<float*>(
        rtcSetNewGeometryBuffer(geometry, type, 0, format, floats * sizeof(float), count));
    std::ranges::transform(values, to, [](double v) { return static_cast<float>(v); });
}

/// Null for a body that Embree has not.
RTCGeometry geometryOf(RTCDevice device, const Body& body) {
    if (const auto* sphere = std::get_if<Sphere>(&body.shape)) {
        const RTCGeometry g = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_SPHERE_POINT);
        const Vec3 c = sphere->centre;
        fill(g, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT4, 4, 1, {c.x, c.y, c.z, sphere->radius});
        return g;
    }
    if (const auto* disc = std::get_if<Disc>(&body.shape)) {
        const RTCGeometry g = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_ORIENTED_DISC_POINT);
        const Vec3 c = disc->centre,
                   n = body.referential ? resolveReferential(*body.referential).y : Vec3{0, 1, 0};
        fill(g, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT4, 4, 1, {c.x, c.y, c.z, disc->radius});
        fill(g, RTC_BUFFER_TYPE_NORMAL, RTC_FORMAT_FLOAT3, 3, 1, {n.x, n.y, n.z});
        return g;
    }
    if (const auto* polygon = std::get_if<Polygon>(&body.shape); polygon && polygon->vertices.size() == 3) {
        const RTCGeometry g = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
        const auto& [a, b, c] = std::tie(polygon->vertices[0], polygon->vertices[1], polygon->vertices[2]);
        fill(g, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, 3, 3,
             {a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z});
        auto* corners = static_cast<unsigned*>(
            rtcSetNewGeometryBuffer(g, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned), 1));
        std::iota(corners, corners + 3, 0U);
        return g;
    }
    return nullptr;
}

RTCDevice sharedDevice() {
    static const std::unique_ptr<RTCDeviceTy, decltype(&rtcReleaseDevice)> device(rtcNewDevice(nullptr),
                                                                                  rtcReleaseDevice);
    return device.get();
}

} // namespace

Case roundedToFloat(Case c) {
    for (Body& body : c.scene.bodies) {
        if (auto* sphere = std::get_if<Sphere>(&body.shape))
            *sphere = {rounded(sphere->centre), rounded(sphere->radius)};
        if (auto* disc = std::get_if<Disc>(&body.shape))
            *disc = {rounded(disc->centre), rounded(disc->radius)};
        if (auto* polygon = std::get_if<Polygon>(&body.shape))
            for (Vec3& vertex : polygon->vertices) vertex = rounded(vertex);
    }
    return {std::move(c.scene), {rounded(c.ray.origin), rounded(c.ray.direction)}};
}

OtherAnswer askEmbree(const Case& c, EmbreeMode mode) {
    for (const double x : {c.ray.origin.x, c.ray.origin.y, c.ray.origin.z})
        if (!(std::abs(x) < largestCoordinate)) return {false, {}};
    const std::unique_ptr<RTCSceneTy, decltype(&rtcReleaseScene)> scene(rtcNewScene(sharedDevice()),
                                                                        rtcReleaseScene);
    rtcSetSceneFlags(scene.get(), mode == EmbreeMode::robust ? RTC_SCENE_FLAG_ROBUST : RTC_SCENE_FLAG_NONE);
    for (std::size_t i = 0; i < c.scene.bodies.size(); ++i) {
        const RTCGeometry geometry = geometryOf(sharedDevice(), c.scene.bodies[i]);
        if (!geometry) return {false, {}};
        rtcCommitGeometry(geometry);
        rtcAttachGeometryByID(scene.get(), geometry, static_cast<unsigned>(i));
        rtcReleaseGeometry(geometry);
    }
    rtcCommitScene(scene.get());
    const auto single = [](double x) { return static_cast<float>(x); };
    const auto& [o, d] = c.ray;
    RTCRayHit ray{};
    ray.ray.org_x = single(o.x), ray.ray.org_y = single(o.y), ray.ray.org_z = single(o.z);
    ray.ray.dir_x = single(d.x), ray.ray.dir_y = single(d.y), ray.ray.dir_z = single(d.z);
    ray.ray.tnear = std::numeric_limits<float>::min(); // a surface that the ray starts on is not ahead of it
    ray.ray.tfar = std::numeric_limits<float>::infinity();
    ray.ray.mask = ~0U;
    ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(scene.get(), &context, &ray);
    if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
    const Vec3 normal = normalised(Vec3{ray.hit.Ng_x, ray.hit.Ng_y, ray.hit.Ng_z});
    return {true, OtherHit{ray.hit.geomID, ray.ray.tfar, normal}};
}

} // namespace yarte::hard
