#include "convert/povray/sdl/build_mesh.h"

#include "convert/povray/sdl/stretch.h"
#include "tests/convert/povray/sdl/support.h"
#include "yarte/scene/mesh_placement.h"
#include "yarte/scene/referential.h"

#include <gtest/gtest.h>

namespace yarte::convert::povray::sdl::test {
namespace {

/// A tetrahedron whose faces are clockwise seen from outside: by the left-hand rule that is the front.
std::shared_ptr<MeshShape> tetrahedron() {
    auto mesh = std::make_shared<MeshShape>();
    mesh->vertices = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
    mesh->faces = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
    return mesh;
}

Vec3 newell(const std::vector<Vec3>& v) { return cross(v.at(1) - v[0], v.at(2) - v[0]); }

/// The corners of a face of a scene's mesh, in the world.
std::vector<Vec3> cornersOf(const Scene& scene, const Mesh& mesh, std::size_t face) {
    const MeshData& data = scene.meshes[mesh.mesh.index];
    const std::vector<Vec3> placed = placedVertices(data, mesh);
    std::vector<Vec3> corners;
    for (const std::uint32_t i : data.face(face)) corners.push_back(placed[i]);
    return corners;
}

TEST(SdlMesh, FacesOutwardsWhateverTheMap) {
    Random random(20);
    for (int i = 0; i < 40; ++i) {
        Affine a = i % 2 ? random.affine() : random.similarity();
        if (i % 4 > 1) a = then(a, scaling({1, -1, 1}));
        const auto mesh = tetrahedron();
        const BuiltScene built(model({object(mesh, a)}));
        for (std::size_t f = 0; f < 4; ++f) {
            const auto corners = cornersOf(*built.scene, built.shape<Mesh>(), f);
            Vec3 middle;
            for (const Vec3 v : mesh->vertices) middle += mapPoint(a, v) / 4;
            EXPECT_GT(dot(newell(corners), corners[0] - middle), 0) << i;
            EXPECT_LE(length(corners[0] - mapPoint(a, mesh->vertices[mesh->faces[f][0]])), 1e-12);
        }
        EXPECT_EQ(built.losses(), "");
    }
}

TEST(SdlMesh, NormalsFollowTheirSide) {
    Random random(21);
    for (int i = 0; i < 20; ++i) {
        auto mesh = tetrahedron();
        mesh->normals = mesh->vertices;
        mesh->faceNormals = mesh->faces;
        Affine a = i % 2 ? random.affine() : random.similarity();
        if (i % 4 > 1) a = then(a, scaling({1, -1, 1}));
        const BuiltScene built(model({object(mesh, a)}));
        const Mesh& placed = built.shape<Mesh>();
        const MeshData& data = built.scene->meshes[placed.mesh.index];
        const Frame axes = resolveReferential(placed.axes);
        for (std::size_t f = 0; f < 4; ++f)
            for (int corner = 0; corner < 3; ++corner) {
                const auto normal =
                    axes.toWorld(data.normals[data.faceNormals(f)[static_cast<std::size_t>(corner)]]);
                const Vec3 at = cornersOf(*built.scene, placed, f)[static_cast<std::size_t>(corner)];
                const Vec3 original = mapPoint(*inverse(a), at);
                EXPECT_LE(length(normal - unit(mapNormal(a, original))), 1e-9);
            }
    }
}

/// POV-Ray maps what it has interpolated, YARTE interpolates unit normals in the world.
TEST(SdlMesh, TellsWhereNormalsInterpolateDifferently) {
    auto mesh = tetrahedron();
    const Affine bent = scaling({1, 3, 0.5}), even = scaling({2, -2, 2});
    EXPECT_EQ(BuiltScene(model({object(mesh, bent)})).losses(), ""); // flat
    mesh->normals = mesh->vertices;
    mesh->faceNormals = mesh->faces;
    EXPECT_EQ(BuiltScene(model({object(mesh, even)})).losses(), "");
    EXPECT_EQ(BuiltScene(model({object(mesh, bent)})).losses(), "mesh: normals: approximated\n");
}

TEST(SdlMesh, IsKeptOnceForItsCopies) {
    const auto mesh = tetrahedron();
    Random random(22);
    std::vector<Object> copies;
    for (int i = 0; i < 10; ++i) copies.push_back(object(mesh, random.similarity()));
    copies.push_back(object(mesh, scaling({-1, 1, 1})));
    copies.push_back(object(mesh, scaling({1, 2, 1})));
    const BuiltScene built(model(copies));
    EXPECT_EQ(built.scene->bodies.size(), 12U);
    EXPECT_EQ(built.scene->meshes.size(), 3U); // as it is, mirrored, bent
}

TEST(SdlMesh, HasABodyForEveryTexture) {
    auto mesh = tetrahedron();
    mesh->textures = {{plain({1, 0, 0})}, {plain({0, 1, 0})}, {plain({0, 0, 1})}};
    mesh->faceTextures = {1, MeshShape::none, 1, 0};
    const BuiltScene built(model({object(mesh)}));
    ASSERT_EQ(built.scene->bodies.size(), 3U);
    EXPECT_EQ(built.scene->materials.size(), 3U);
    const auto& first = built.scene->meshes[built.shape<Mesh>(0).mesh.index];
    EXPECT_EQ(first.faceCount(), 1U);
    EXPECT_EQ(first.vertices.size(), 3U); // only those it needs
    EXPECT_EQ(built.scene->meshes[built.shape<Mesh>(1).mesh.index].faceCount(), 2U);
    EXPECT_EQ(built.losses(), "");
}

TEST(SdlMesh, DropsFacesWithoutAreaAndCountsThem) {
    auto mesh = tetrahedron();
    mesh->faces.push_back({0, 0, 1});
    mesh->faces.push_back({2, 2, 2});
    const BuiltScene built(model({object(mesh)}));
    EXPECT_EQ(built.scene->meshes.at(0).faceCount(), 4U);
    EXPECT_EQ(built.losses(), "mesh: faces: dropped\n");
    EXPECT_NE(describe(built.ledger.rows()[0]).find("2 have no area"), std::string::npos);
}

Object triangle(Vec3 a, Vec3 b, Vec3 c, bool isSmooth = false) {
    TriangleShape t{{a, b, c}, {}};
    if (isSmooth) t.normals = {{Vec3{0, 0, 2}, Vec3{0.1, 0, 1}, Vec3{0, 0.1, 1}}};
    return object(t);
}

TEST(SdlTriangles, OneIsAPolygonAndManyAreAMesh) {
    const BuiltScene one(model({triangle({0, 0, 0}, {0, 1, 0}, {1, 0, 0})}));
    EXPECT_EQ(one.shape<Polygon>().vertices, (std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));

    std::vector<Object> strip;
    for (int i = 0; i < 1000; ++i)
        strip.push_back(triangle({1.0 * i, 0, 0}, {i + 1.0, 0, 0}, {1.0 * i, 1, 0}, i % 3 == 1));
    const BuiltScene many(model(strip));
    ASSERT_EQ(many.scene->bodies.size(), 1U);
    const MeshData& data = many.scene->meshes.at(0);
    EXPECT_EQ(data.faceCount(), 1000U);
    EXPECT_EQ(data.vertices.size(), 2001U);
    EXPECT_EQ(data.normals.size(), 4U); // of the flat ones: one; of the smooth ones: three
    EXPECT_EQ(data.normals[data.faceNormals(0)[2]], (Vec3{0, 0, -1}));
    EXPECT_EQ(data.normals[data.faceNormals(1)[0]], (Vec3{0, 0, 1}));
}

TEST(SdlTriangles, RunsEndWhereTheLookDoes) {
    Object red = triangle({0, 0, 0}, {0, 1, 0}, {1, 0, 0}), blue = red, clear = red;
    red.appearance.layers = Layers{plain({1, 0, 0})};
    blue.appearance.layers = Layers{plain({0, 0, 1})};
    clear.appearance.layers = Layers{plain({1, 1, 1, 0, 0.5})};
    EXPECT_EQ(BuiltScene(model({red, red, blue, blue, red})).scene->bodies.size(), 3U);
    EXPECT_EQ(BuiltScene(model({red, object(SphereShape{}), red})).scene->bodies.size(), 3U);
    // Each transparent triangle is a medium of its own, unless the union around it has an interior.
    EXPECT_EQ(BuiltScene(model({clear, clear})).scene->bodies.size(), 2U);
    Object both = object(UnionShape{{shared(clear), shared(clear)}});
    EXPECT_EQ(BuiltScene(model({both})).scene->bodies.size(), 2U);
    both.appearance.interior = Interior{1.5, {}};
    const BuiltScene glass(model({both}));
    EXPECT_EQ(glass.scene->bodies.size(), 1U);
    EXPECT_EQ(glass.scene->materials.at(0).index, 1.5);
}

TEST(SdlTriangles, MillionsPass) {
    auto mesh = std::make_shared<MeshShape>();
    for (std::uint32_t i = 0; i < 500'000; ++i)
        mesh->vertices.push_back({static_cast<double>(i % 1000), static_cast<double>(i / 1000), 0});
    for (std::uint32_t i = 0; i + 1001 < 500'000; ++i)
        mesh->faces.push_back({i, i + 1, i + 1000}), mesh->faces.push_back({i + 1, i + 1001, i + 1000});
    const BuiltScene built(model({object(mesh)}));
    EXPECT_EQ(built.scene->meshes.at(0).faceCount(), mesh->faces.size());
}

} // namespace
} // namespace yarte::convert::povray::sdl::test
