// What our own writer makes of a scene comes back as it was, bit for bit.
#include "convert/povray/sdl/build_exact.h"

#include "tests/convert/povray/sdl/support.h"
#include "yarte/scene/referential.h"

#include <gtest/gtest.h>

#include <cmath>

namespace yarte::convert::povray::sdl::test {
namespace {

constexpr double unitLength = 4096;

/// As `matrix <X, Y, Z, 0, 0, 0>` and a move, with the axes as written.
Object placed(ObjectShape shape, Vec3 centre, const std::optional<Referential>& axes = {}) {
    Object result = object(std::move(shape));
    if (axes) {
        const Frame f = resolveReferential(*axes);
        result.transform = {f.x, f.y, f.z, {}};
        result.exactAxes = axes;
    }
    result.transform = then(result.transform, translation(centre * unitLength));
    return result;
}

Model ours(std::vector<Object> objects) {
    Model m = model(std::move(objects));
    m.unit = unitLength;
    m.gamma = 1.8, m.resolution = Resolution{123, 45};
    m.exactMaterials = {{{0.1, 0.2, 0.3}, {0.4, 0.5, 0.6}, {0.7, 0.8, 0.9}, 12, 0.25, 0, 0},
                        {{}, {}, {}, 1, 0, 0.5, 1.5}};
    for (ObjectPtr& o : m.objects) {
        Object copy = *o;
        copy.appearance.exact = ExactMaterial{{1}, {}};
        o = shared(std::move(copy));
    }
    m.camera->exact = Camera{{0.1, 0.2, 0.3}, {1, 2, 3}, {0, 1, 1}, 33, 22};
    return m;
}

const Vec3 centre{0.1, -2.3, 1e-7};
const Referential turned{{0.7071, 0, 0.7071}, {0, 1, 0}, {}};

TEST(ExactScene, ShapesComeBackAsTheyWere) {
    const double r = 0.3, h = 1.1;
    const Vec3 sides{0.7, 1.3, 1e-3}, up{0, h * unitLength, 0};
    for (const auto& axes : {std::optional<Referential>(), std::optional(turned)}) {
        const Vec3 half = sides / 2 * unitLength;
        const BuiltScene built(ours({
            object(SphereShape{centre * unitLength, r * unitLength}),
            placed(BoxShape{-half, half}, centre, axes),
            placed(ConeShape{{}, r * unitLength, up, 0, false}, centre, axes),
            placed(ConeShape{{}, r * unitLength, up, r * unitLength, false}, centre, axes),
            placed(ConeShape{{}, r * unitLength, up, r * unitLength, true}, centre, axes),
            placed(ConeShape{{}, r * unitLength, up, 2 * r * unitLength, false}, centre, axes),
            placed(DiscShape{{}, {0, 1, 0}, r * unitLength, 0}, centre, axes),
            object(PlaneShape{{0, 0.3, -4}, 0.7 * unitLength}),
        }));
        ASSERT_TRUE(built.scene);
        const auto expect = [&](std::size_t i, const Shape& shape) {
            EXPECT_EQ(built.scene->bodies.at(i).shape, shape) << i;
            EXPECT_EQ(built.scene->bodies[i].referential, takesReferential(shape) ? axes : std::nullopt) << i;
            EXPECT_EQ(built.scene->bodies[i].material, MaterialId{1});
        };
        expect(0, Sphere{centre, r});
        expect(1, Box{centre, sides});
        expect(2, Cone{centre, r, h});
        expect(3, Cylinder{centre, r, h});
        expect(4, OpenCylinder{centre, r, h});
        expect(5, Frustum{centre, r, 2 * r, h});
        expect(6, Disc{centre, r});
        expect(7, Plane{{0, 0.3, -4}, 0.7});
        EXPECT_EQ(built.losses(), "");
    }
}

TEST(ExactScene, SettingsAndUnusedThingsStay) {
    Model m = ours({object(ExactShape{Mesh{{0}, 2, turned, centre}}),
                    object(LightShape{centre * unitLength, {1, 2, 3}, {}, false, nullptr})});
    m.exactMeshes.resize(2);
    m.exactMeshes[0].path = "a.pmf", m.exactMeshes[0].vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, -0.0}};
    m.exactMeshes[0].corners = {0, 1, 2}, m.exactMeshes[0].faceStarts = {0, 3};
    m.exactMeshes[1] = m.exactMeshes[0], m.exactMeshes[1].path = "b.pmf";
    const BuiltScene built(m);
    ASSERT_TRUE(built.scene);
    EXPECT_EQ(built.scene->materials, m.exactMaterials);
    EXPECT_EQ(built.scene->meshes, m.exactMeshes);
    EXPECT_EQ(built.shape<Mesh>(), (Mesh{{0}, 2, turned, centre}));
    EXPECT_EQ(built.scene->camera, *m.camera->exact);
    EXPECT_EQ(built.scene->lights, (std::vector<Light>{{centre, {1, 2, 3}, {}}}));
    EXPECT_EQ(built.scene->gamma, 1.8);
    EXPECT_EQ(built.scene->resolution, (Resolution{123, 45}));
}

TEST(ExactScene, NegativeZerosStay) {
    const BuiltScene built(ours({object(SphereShape{{-0.0, 1, -0.0}, unitLength}),
                                 placed(BoxShape{{-1, -1, -1}, {1, 1, 1}}, {-0.0, 2, 0})}));
    EXPECT_TRUE(std::signbit(built.shape<Sphere>(0).centre.x));
    EXPECT_TRUE(std::signbit(built.shape<Box>(1).centre.x));
    EXPECT_FALSE(std::signbit(built.shape<Box>(1).centre.z));
}

/// Somebody put our objects into a union and moved it, or changed the camera.
TEST(ExactScene, MovedShapesAreMoved) {
    const std::vector<Vec3> triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    Model m = ours({object(ExactShape{Polygon{triangle}}),
                    object(ExactShape{Mesh{{0}, 2, {{1, 0, 0}, {0, 1, 0}, Vec3{0, 0, 1}}, {}}}),
                    object(ExactShape{TruncatedCone{{1, 0, 0}, 1, 3, 2}})});
    m.exactMeshes.resize(1);
    m.exactMeshes[0].vertices = triangle, m.exactMeshes[0].corners = {0, 1, 2},
    m.exactMeshes[0].faceStarts = {0, 3};
    const Affine moved =
        then(then(rotation({0, 0, 90}), scaling({3, 3, 3})), translation({unitLength, 0, 0}));
    Model inUnion = m;
    Object whole = object(UnionShape{m.objects}, moved);
    inUnion.objects = {shared(whole)};
    const BuiltScene built(inUnion);
    EXPECT_EQ(built.losses(), "");
    EXPECT_EQ(built.shape<Polygon>(0).vertices, (std::vector<Vec3>{{1, 0, 0}, {1, 3, 0}, {-2, 0, 0}}));
    EXPECT_EQ(built.shape<Mesh>(1).scale, 6);
    EXPECT_EQ(built.shape<Mesh>(1).axes.x, (Vec3{0, 1, 0}));
    EXPECT_EQ(built.shape<Mesh>(1).translation, (Vec3{1, 0, 0}));
    EXPECT_EQ(built.shape<TruncatedCone>(2), (TruncatedCone{{1, 3, 0}, 3, 9, 6}));
    EXPECT_EQ(built.scene->bodies[2].referential->x, (Vec3{0, 1, 0}));

    inUnion.objects = m.objects, inUnion.camera->exact.reset(), inUnion.camera->right.x *= -1; // left-handed
    const BuiltScene mirrored(inUnion);
    EXPECT_EQ(mirrored.losses(), "");
    EXPECT_EQ(mirrored.shape<Polygon>(0).vertices, (std::vector<Vec3>{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}}));
    EXPECT_EQ(mirrored.scene->meshes.back().vertices[1], (Vec3{2 * unitLength, 0, 0}));
    EXPECT_EQ(mirrored.shape<Mesh>(1).scale, 1 / unitLength);
    EXPECT_EQ(mirrored.scene->meshes.back().corners, (std::vector<std::uint32_t>{0, 2, 1}));
    EXPECT_EQ(mirrored.shape<TruncatedCone>(2), (TruncatedCone{{1, 0, -0.0}, 1, 3, 2}));
}

} // namespace
} // namespace yarte::convert::povray::sdl::test
