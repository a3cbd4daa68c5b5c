// embree_bench [RUNS [SIDE]]: primary rays on a height field of 2 SIDE^2 triangles (708: a million), 1024 x
// 1024 of them, on one thread: YARTE's tracer, which is exact in double precision, beside Embree's own
// triangles in single precision and packets.
//
// YARTE renders the picture of a scene without lights, so that its time is that of making the rays, finding
// and describing the hits, and writing pixels; Embree is handed the same rays and only finds the hits. Prints
// JSON: seconds of RUNS runs in turn, and how many pixels are hit.
#include "tests/bench/height_field.h"
#include "yarte/trace/camera.h"
#include "yarte/trace/render_tile.h"

#include <embree3/rtcore.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <limits>
#include <memory>
#include <numeric>
#include <utility>
#include <vector>

namespace {

using namespace yarte;

constexpr int size = 1024;
constexpr int tileSide = 32; // the program's default

/// What is hit is white, by ambient light alone.
Scene sceneOf(MeshData mesh) {
    Scene scene;
    scene.camera.position = {0, 1.6, 2.2}, scene.camera.focus = {0, -0.1, 0};
    scene.camera.horizontalApertureDegrees = scene.camera.verticalApertureDegrees = 30;
    scene.maxRecursion = 0;
    scene.materials = {{{1, 1, 1}, {}, {}, 1, 0, 0, 0}};
    scene.meshes.push_back(std::move(mesh));
    scene.bodies.push_back({Mesh{{0}, 1, {{1, 0, 0}, {0, 1, 0}, Vec3{0, 0, 1}}, {}}, {0}, {}, {}, {}});
    return scene;
}

/// Of each pixel, row by row: whether its ray hits the mesh.
using Hits = std::vector<char>;

constexpr std::size_t indexOf(int x, int y) {
    return static_cast<std::size_t>(y) * size + static_cast<std::size_t>(x);
}

class Yarte {
public:
    explicit Yarte(const Scene& scene) : world_(buildWorld(scene, {size, size})), pixels_(size * size) {}

    void render() {
        RayCounts counts;
        for (int y = 0; y < size; y += tileSide)
            for (int x = 0; x < size; x += tileSide)
                renderTile(*world_, {x, y, x + tileSide, y + tileSide}, &pixels_[indexOf(x, y)], size,
                           counts);
    }
    Hits hits() const {
        Hits hits;
        for (const Colour& pixel : pixels_) hits.push_back(pixel.r > 0);
        return hits;
    }

private:
    WorldPtr world_;
    std::vector<Colour> pixels_;
};

/// Packets of Embree's API by their number of rays, which is that of a square of pixels.
template <int lanes>
struct Packet;
template <>
struct Packet<16> {
    using RayHits = RTCRayHit16;
    static constexpr int width = 4, height = 4;
    static constexpr auto intersect = rtcIntersect16;
};
template <>
struct Packet<8> {
    using RayHits = RTCRayHit8;
    static constexpr int width = 4, height = 2;
    static constexpr auto intersect = rtcIntersect8;
};

class Embree {
public:
    Embree(RTCDevice device, const Scene& scene, RTCSceneFlags flags)
        : scene_(rtcNewScene(device), rtcReleaseScene), camera_(scene.camera, {size, size}),
          hits_(size * size) {
        const MeshData& mesh = scene.meshes[0];
        const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
        auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(
            geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), mesh.vertices.size()));
        for (const Vec3 v : mesh.vertices)
            for (const double component : {v.x, v.y, v.z}) *vertices++ = static_cast<float>(component);
        auto* corners = static_cast<std::uint32_t*>(
            rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                    3 * sizeof(std::uint32_t), mesh.faceCount()));
        std::ranges::copy(mesh.corners, corners);
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene_.get(), geometry);
        rtcReleaseGeometry(geometry);
        rtcSetSceneFlags(scene_.get(), flags);
        rtcSetSceneBuildQuality(scene_.get(), RTC_BUILD_QUALITY_HIGH);
        rtcCommitScene(scene_.get());
    }

    /// Made beforehand: what is measured is Embree, not the making of rays.
    template <int lanes>
    void makeRays() {
        using P = Packet<lanes>;
        for (int y0 = 0; y0 < size; y0 += P::height)
            for (int x0 = 0; x0 < size; x0 += P::width)
                for (const auto component : {&Vec3::x, &Vec3::y, &Vec3::z})
                    for (int i = 0; i < lanes; ++i)
                        directions_.push_back(static_cast<float>(
                            camera_.through(x0 + i % P::width, y0 + i / P::width).direction.*component));
    }

    template <int lanes>
    void trace() {
        using P = Packet<lanes>;
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
        alignas(64) int valid[lanes];
        std::fill_n(valid, lanes, -1);
        typename P::RayHits packet{};
        std::fill_n(packet.ray.mask, lanes, ~0u);
        std::fill_n(packet.ray.org_x, lanes, static_cast<float>(camera_.position.x));
        std::fill_n(packet.ray.org_y, lanes, static_cast<float>(camera_.position.y));
        std::fill_n(packet.ray.org_z, lanes, static_cast<float>(camera_.position.z));
        const float* direction = directions_.data();
        for (int y0 = 0; y0 < size; y0 += P::height)
            for (int x0 = 0; x0 < size; x0 += P::width) {
                for (float* component : {packet.ray.dir_x, packet.ray.dir_y, packet.ray.dir_z}) {
                    std::copy_n(direction, lanes, component);
                    direction += lanes;
                }
                std::fill_n(packet.ray.tfar, lanes, std::numeric_limits<float>::infinity());
                std::fill_n(packet.hit.geomID, lanes, RTC_INVALID_GEOMETRY_ID);
                P::intersect(valid, scene_.get(), &context, &packet);
                for (int i = 0; i < lanes; ++i)
                    hits_[indexOf(x0 + i % P::width, y0 + i / P::width)] =
                        packet.hit.geomID[i] != RTC_INVALID_GEOMETRY_ID;
            }
    }
    const Hits& hits() const { return hits_; }

private:
    std::unique_ptr<RTCSceneTy, decltype(&rtcReleaseScene)> scene_;
    trace::CameraRays camera_;
    std::vector<float> directions_; ///< x, y and z of one packet after the other
    Hits hits_;
};

/// Of the processor's time: what else runs on the machine disturbs it less.
double secondsOf(const std::function<void()>& work) {
    const std::clock_t begin = std::clock();
    work();
    return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
}

std::size_t differences(const Hits& a, const Hits& b) {
    return static_cast<std::size_t>(
        std::inner_product(a.begin(), a.end(), b.begin(), 0, std::plus<>(), std::not_equal_to<>()));
}

template <int lanes>
void compare(RTCDevice device, const Scene& scene, int runs) {
    Yarte yarte(scene);
    Embree fast(device, scene, RTC_SCENE_FLAG_NONE), robust(device, scene, RTC_SCENE_FLAG_ROBUST);
    fast.makeRays<lanes>(), robust.makeRays<lanes>();
    std::vector<double> yarteSeconds, fastSeconds, robustSeconds;
    for (int i = -1; i < runs; ++i) { // one more, which is not counted: its memory is new
        const double seconds[] = {secondsOf([&] { yarte.render(); }), secondsOf([&] { fast.trace<lanes>(); }),
                                  secondsOf([&] { robust.trace<lanes>(); })};
        if (i < 0) continue;
        yarteSeconds.push_back(seconds[0]), fastSeconds.push_back(seconds[1]),
            robustSeconds.push_back(seconds[2]);
    }
    const Hits hits = yarte.hits();
    fmt::print("{{\"triangles\": {}, \"rays\": {}, \"hits\": {}, \"packet\": {},\n"
               " \"yarte\": {{\"seconds\": {}}},\n"
               " \"embree\": {{\"seconds\": {}, \"different\": {}}},\n"
               " \"robust\": {{\"seconds\": {}, \"different\": {}}}}}\n",
               scene.meshes[0].faceCount(), hits.size(), std::ranges::count(hits, 1), lanes, yarteSeconds,
               fastSeconds, differences(hits, fast.hits()), robustSeconds, differences(hits, robust.hits()));
}

} // namespace

int main(int argc, char** argv) {
    const int runs = argc > 1 ? std::atoi(argv[1]) : 5, side = argc > 2 ? std::atoi(argv[2]) : 708;
    if (runs < 1 || side < 1) return 2;
    const Scene scene = sceneOf(bench::heightField(side));
    const std::unique_ptr<RTCDeviceTy, decltype(&rtcReleaseDevice)> device(rtcNewDevice("hugepages=1"),
                                                                           rtcReleaseDevice);
    // On a processor without vectors of 16 Embree would take packets of as many apart.
    if (rtcGetDeviceProperty(device.get(), RTC_DEVICE_PROPERTY_NATIVE_RAY16_SUPPORTED) != 0)
        compare<16>(device.get(), scene, runs);
    else
        compare<8>(device.get(), scene, runs);
}
