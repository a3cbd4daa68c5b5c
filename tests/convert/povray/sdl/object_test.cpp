#include "convert/povray/sdl/build_body.h"

#include "tests/convert/povray/sdl/support.h"
#include "yarte/scene/mesh_placement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace yarte::convert::povray::sdl::test {
namespace {

const Layers red{plain({1, 0, 0})}, green{plain({0, 1, 0})}, blue{plain({0, 0, 1})},
    clear{plain({1, 1, 1, 0, 0.5})};

const Material& materialOf(const BuiltScene& built, std::size_t body) {
    return built.scene->materials.at(built.scene->bodies.at(body).material.index);
}

TEST(SdlObject, PartsHaveTheUnionsPlaceAndLook) {
    Object own = object(SphereShape{{1, 0, 0}, 1}, translation({0, 1, 0})),
           plainPart = object(SphereShape{{2, 0, 0}, 1});
    own.appearance.layers = green;
    Object inner = object(UnionShape{{shared(own), shared(plainPart)}}, scaling({2, 2, 2}));
    Object outer = object(UnionShape{{shared(inner)}}, translation({0, 0, 5}));
    outer.appearance.layers = red;
    const BuiltScene built(model({outer, object(SphereShape{})}));
    ASSERT_EQ(built.scene->bodies.size(), 3U);
    EXPECT_EQ(built.shape<Sphere>(0), (Sphere{{2, 2, 5}, 2}));
    EXPECT_EQ(built.shape<Sphere>(1), (Sphere{{4, 0, 5}, 2}));
    EXPECT_EQ(materialOf(built, 0).diffuse, (Colour{0, 0.6, 0}));
    EXPECT_EQ(materialOf(built, 1).diffuse, (Colour{0.6, 0, 0}));
    EXPECT_EQ(materialOf(built, 2).diffuse, Colour()); // the default texture's pigment is black
    EXPECT_EQ(built.losses(), "");
}

/// Measured: a part with a texture of its own shows the union's interior_texture from behind.
TEST(SdlObject, BacksAreInheritedOnTheirOwn) {
    Object disc = object(DiscShape{});
    disc.appearance.layers = red;
    Object whole = object(UnionShape{{shared(disc), shared(object(SphereShape{}))}});
    whole.appearance.layers = blue, whole.appearance.backLayers = green;
    const BuiltScene built(model({whole}));
    EXPECT_EQ(built.scene->bodies.at(0).back->diffuse, (Colour{0, 0.6, 0}));
    EXPECT_FALSE(built.scene->bodies.at(1).back); // a sphere's is seen only from inside
    EXPECT_EQ(built.losses(), "");
    whole.appearance.layers = clear;
    EXPECT_EQ(BuiltScene(model({whole})).losses(), "sphere: levels: approximated\n"
                                                   "sphere: back: transmission: approximated\n"
                                                   "sphere: interior_texture: dropped\n");
}

TEST(SdlObject, EqualLooksShareAMaterial) {
    std::vector<Object> spheres;
    for (int i = 0; i < 1000; ++i) {
        spheres.push_back(object(SphereShape{{1.0 * i, 0, 0}, 1}));
        spheres.back().appearance.layers = i % 2 ? red : green;
    }
    EXPECT_EQ(BuiltScene(model(spheres)).scene->materials.size(), 2U);
}

TEST(SdlObject, TrianglesOfARoundPartAreKeptOnceForItsSimilarPlaces) {
    Random random(7);
    const ObjectPtr part = shared(object(TorusShape{3, 1}, random.affine()));
    const ObjectPtr egg = shared(object(SphereShape{{1, 2, 3}, 2}, scaling({1, 2, 3})));
    std::vector<Object> places;
    for (int i = 0; i < 4; ++i) places.push_back(object(UnionShape{{part, egg}}, random.similarity()));
    places.push_back(object(UnionShape{{part, egg}}, random.affine())); // these are made anew
    const BuiltScene built(model(places));
    ASSERT_EQ(built.scene->bodies.size(), 10U);
    EXPECT_EQ(built.scene->meshes.size(), 4U);
    for (std::size_t i = 0; i < 10; ++i) {
        const BuiltScene alone(model({places[i / 2]}));
        const Mesh &mesh = built.shape<Mesh>(i), &expected = alone.shape<Mesh>(i % 2);
        const auto vertices = placedVertices(built.scene->meshes[mesh.mesh.index], mesh);
        const auto right = placedVertices(alone.scene->meshes[expected.mesh.index], expected);
        ASSERT_EQ(vertices.size(), right.size());
        double farthest = 0;
        for (std::size_t v = 0; v < right.size(); ++v)
            farthest = std::max(farthest, length(vertices[v] - right[v]));
        EXPECT_LT(farthest, 1e-11) << i;
    }
}

TEST(SdlObject, AMergeOfOpaquePartsIsTheirUnion) {
    Object merge =
        object(UnionShape{{shared(object(SphereShape{})), shared(object(BoxShape{{}, {1, 1, 1}}))}, true});
    EXPECT_EQ(BuiltScene(model({merge})).losses(), "");
    merge.appearance.layers = clear, merge.appearance.interior = Interior{1.5, {"media"}};
    EXPECT_EQ(BuiltScene(model({merge})).losses(), "sphere: interior: media: dropped\n"
                                                   "box: interior: media: dropped\n"
                                                   "merge: merge: approximated\n"
                                                   "merge: interior: approximated\n");
}

TEST(SdlObject, TellsWhatHasNoCounterpart) {
    Object sphere = object(SphereShape{}), hidden = object(SphereShape{});
    sphere.ignored = {"no_shadow"}, hidden.isHidden = true;
    const BuiltScene built(
        model({object(UnsupportedShape{"isosurface"}), sphere, hidden, object(SphereShape{{}, 0})}));
    EXPECT_EQ(built.losses(), "isosurface: everything: dropped\n"
                              "sphere: no_shadow: dropped\n"
                              "sphere: everything: dropped\n"
                              "sphere: everything: dropped\n");
    EXPECT_EQ(built.scene->bodies.size(), 1U);
}

TEST(SdlObject, NamesThePlaceOnceForEverythingMadeThere) {
    Sources sources;
    const SourceId id = sources.add("scene.pov", "#for(I,1,3)\n  blob { }\n#end\n");
    Object blob = object(UnsupportedShape{"blob"});
    blob.span = {id, 14, 18};
    Diagnostics diagnostics;
    Ledger ledger;
    ASSERT_TRUE(buildScene(model({blob, blob, blob}), {}, sources, diagnostics, ledger));
    EXPECT_EQ(describe(ledger.rows()[0]),
              "blob at scene.pov:2:3: everything dropped: there is no such shape (3 times)");
}

TEST(SdlObject, LightsArePoints) {
    LightShape light{{1, 2, 3}, {1, 0.5, -0.25}, {"spotlight"}, true, shared(object(SphereShape{}))};
    const Object within = object(UnionShape{{shared(object(light))}}, translation({0, 0, 5}));
    const BuiltScene built(model({within}));
    EXPECT_EQ(built.scene->lights, (std::vector<Light>{{{1, 2, 8}, {1, 0.5, 0}, {}}}));
    EXPECT_EQ(built.losses(), "light_source: spotlight: approximated\n"
                              "light_source: shadowless: approximated\n"
                              "light_source: looks_like: dropped\n"
                              "light_source: colour: approximated\n");
}

TEST(SdlObject, ParallelRaysComeFromFarAway) {
    LightShape light{{3, 3, 0}, {1, 1, 1}, {"spotlight", "parallel"}, false, nullptr};
    light.pointAt = Vec3{2, 0, 0};
    const Object within = object(UnionShape{{shared(object(light))}}, scaling({1, 2, 1}));
    Model m = model({object(SphereShape{{1, -3, 0}, 1}), within});
    const BuiltScene built(m);
    // Nothing is behind the light's plane, and the sphere's far side is 10 or less away.
    const Vec3 way = built.scene->lights.at(0).position - Vec3{3, 6, 0};
    EXPECT_LE(length(normalised(way) - normalised(Vec3{1, 6, 0})), 1e-12);
    EXPECT_GE(length(way), 1e6 * (std::hypot(2, 9) + 1));
    EXPECT_EQ(built.losses(), "light_source: parallel: approximated\n");
    const auto& rows = built.ledger.rows();
    const auto told = std::ranges::find_if(rows, [](const LedgerRow& r) { return r.property == "parallel"; });
    EXPECT_NEAR(told->bound.value(), 1e-6, 1e-8);

    m.objects.push_back(shared(object(SphereShape{{0, 20, 0}, 1}))); // in POV-Ray it casts no shadow
    EXPECT_EQ(BuiltScene(m).losses(),
              "light_source: parallel: approximated\nlight_source: parallel: approximated\n");
    light.pointAt = light.position;
    EXPECT_EQ(BuiltScene(model({object(light)})).losses(), "light_source: everything: dropped\n");
    light.pointAt->x = std::numeric_limits<double>::infinity();
    EXPECT_FALSE(BuiltScene(model({object(light)})).scene);
}

TEST(SdlObject, InfiniteNumbersAreErrors) {
    const double infinity = std::numeric_limits<double>::infinity();
    auto mesh = std::make_shared<MeshShape>();
    mesh->vertices = {{0, 0, 0}, {1, 0, 0}, {0, infinity, 0}};
    mesh->faces = {{0, 1, 2}};
    for (const Object& bad :
         {object(SphereShape{{infinity, 0, 0}, 1}), object(SphereShape{{}, infinity}),
          object(BoxShape{{}, {1, infinity, 1}}), object(mesh), object(PlaneShape{{0, 1, 0}, infinity}),
          object(ConeShape{{}, infinity, {0, 1, 0}, 1}), object(DiscShape{{}, {0, 1, infinity}, 1}),
          object(TorusShape{infinity, 1}), object(LightShape{{infinity, 0, 0}, {}, {}, false, nullptr}),
          object(TriangleShape{{Vec3{}, Vec3{1, 0, 0}, Vec3{infinity, 1, 0}}, {}}),
          object(PolygonShape{{{{0, 0, 0}, {1, 0, 0}, {0, infinity, 0}}}})}) {
        const BuiltScene built(model({bad}));
        // An error, or dropped with a reason: never a body with such numbers.
        if (!built.scene) continue;
        EXPECT_NE(built.losses(), "");
        EXPECT_TRUE(built.scene->bodies.empty() && built.scene->lights.empty());
    }
}

TEST(SdlObject, SettingsAreTheScenes) {
    Model m = model({});
    m.maxTraceLevel = 7, m.background = {0.5, -1, 2};
    BuiltScene built(m, {{}, {320, 200}});
    ASSERT_TRUE(built.scene);
    EXPECT_EQ(built.scene->maxRecursion, 6);
    EXPECT_EQ(built.scene->background, (Colour{0.5, 0, 2}));
    EXPECT_EQ(built.scene->resolution, (Resolution{320, 200}));
    EXPECT_EQ(built.scene->gamma, 2.2);
    m.background = {}, m.maxTraceLevel = 1000, m.languageVersion = 3.1;
    EXPECT_EQ(BuiltScene(m).scene->maxRecursion, 255);
    EXPECT_EQ(BuiltScene(m).scene->gamma, 1);
    m.assumedGamma = 2.2;
    EXPECT_EQ(BuiltScene(m).scene->gamma, 1);
    m.assumedGamma = 1;
    EXPECT_EQ(BuiltScene(m).scene->gamma, 2.2);
}

} // namespace
} // namespace yarte::convert::povray::sdl::test
