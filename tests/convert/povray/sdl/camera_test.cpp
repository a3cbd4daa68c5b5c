#include "convert/povray/sdl/build_camera.h"

#include "tests/convert/povray/sdl/support.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace yarte::convert::povray::sdl::test {
namespace {

Vec3 mirrored(Vec3 v) { return {v.x, v.y, -v.z}; }

/// The ray of YARTE's camera (right = forward x up) through a point of the picture from -1 to 1.
Vec3 yarteRay(const Camera& c, double x, double y) {
    const Vec3 f = normalised(c.focus - c.position), r = normalised(cross(f, c.up)), u = cross(r, f);
    const auto tangent = [](double degrees) { return std::tan(degrees * std::numbers::pi / 180); };
    return normalised(f + r * (x * tangent(c.horizontalApertureDegrees)) +
                      u * (y * tangent(c.verticalApertureDegrees)));
}

/// POV-Ray's: direction + x/2*right + y/2*up.
Vec3 povrayRay(const CameraModel& c, double x, double y) {
    return normalised(c.direction + c.right * (x / 2) + c.up * (y / 2));
}

TEST(SdlCamera, SeesWhatPovrayDoes) {
    Random random(40);
    for (int i = 0; i < 40; ++i) {
        // A look_at camera: perpendicular vectors of any length, left- or right-handed.
        const Affine turn = rotation(random.inCube(180));
        CameraModel camera;
        camera.location = random.inCube(9);
        camera.direction = turn.z * random.between(0.5, 3);
        camera.right = turn.x * random.between(0.5, 3) * (i % 2 ? 1 : -1);
        camera.up = turn.y * random.between(0.5, 3);
        Model m = model({object(SphereShape{{1, 2, 3}, 1})});
        m.camera = camera;
        m.objects.push_back(shared(object(LightShape{{4, 5, 6}, {1, 1, 1}, {}, false, nullptr})));
        const BuiltScene built(m);
        ASSERT_TRUE(built.scene);
        EXPECT_EQ(isLeftHanded(camera), i % 2 == 1);
        const auto inWorld = [&](Vec3 v) { return i % 2 ? mirrored(v) : v; };
        EXPECT_EQ(built.scene->camera.position, inWorld(camera.location));
        EXPECT_EQ(built.shape<Sphere>().centre, inWorld({1, 2, 3}));
        EXPECT_EQ(built.scene->lights.at(0).position, inWorld({4, 5, 6}));
        for (const double x : {-1.0, 0.0, 0.7})
            for (const double y : {-0.9, 0.2})
                EXPECT_LE(length(yarteRay(built.scene->camera, x, y) - inWorld(povrayRay(camera, x, y))),
                          1e-12);
        EXPECT_EQ(built.losses(), "");
    }
}

TEST(SdlCamera, IsPovraysDefaultIfThereIsNone) {
    Model m = model({object(SphereShape{{1, 2, 3}, 1})});
    m.camera.reset();
    const BuiltScene built(m);
    EXPECT_EQ(built.scene->camera.position, Vec3());
    EXPECT_EQ(built.scene->camera.focus, (Vec3{0, 0, -1})); // left-handed: mirrored
    EXPECT_NEAR(built.scene->camera.horizontalApertureDegrees, std::atan(1.33 / 2) * 180 / std::numbers::pi,
                1e-12);
    EXPECT_NEAR(built.scene->camera.verticalApertureDegrees, 26.56505117707799, 1e-12);
    EXPECT_TRUE(built.ledger.wasAdded("camera"));
}

TEST(SdlCamera, OrthographicIsSeenFromFarAway) {
    Model m = model({object(SphereShape{{0, 0, 0}, 1})});
    m.camera->kind = "orthographic";
    m.camera->right = {6, 0, 0}, m.camera->up = {0, 4, 0};
    const BuiltScene built(m);
    const Camera& c = built.scene->camera;
    // In the middle of the sphere the picture's half-sides are 3 and 2.
    const double distance = c.position.z;
    EXPECT_GT(distance, 1000);
    EXPECT_NEAR(std::tan(c.horizontalApertureDegrees * std::numbers::pi / 180) * distance, 3, 1e-9);
    EXPECT_NEAR(std::tan(c.verticalApertureDegrees * std::numbers::pi / 180) * distance, 2, 1e-9);
    EXPECT_EQ(built.losses(), "camera: orthographic: approximated\n");
    m.camera->location = {0, 0, 0};
    EXPECT_EQ(BuiltScene(m).losses(),
              "camera: orthographic: approximated\ncamera: orthographic: approximated\n");
}

TEST(SdlCamera, TellsOfShearAndKinds) {
    Model m = model({});
    m.camera->right = {4, 0, 1};
    m.camera->kind = "fisheye", m.camera->ignored = {"focal_blur"};
    const BuiltScene built(m);
    EXPECT_EQ(
        built.losses(),
        "camera: right and up: approximated\ncamera: kind: approximated\ncamera: focal_blur: dropped\n");
    EXPECT_NEAR(*built.ledger.rows().at(2).bound, std::atan(0.25) * 180 / std::numbers::pi, 1e-9);
}

TEST(SdlCamera, WithoutDirectionIsAnError) {
    Model m = model({});
    m.camera->direction = {};
    const BuiltScene built(m);
    EXPECT_FALSE(built.scene);
    EXPECT_TRUE(built.diagnostics.hasErrors());
    m.camera->direction = {1, 0, 0}, m.camera->right = {0, 0, 1}, m.camera->up = {2, 0, 0};
    EXPECT_FALSE(BuiltScene(m).scene);
}

} // namespace
} // namespace yarte::convert::povray::sdl::test
