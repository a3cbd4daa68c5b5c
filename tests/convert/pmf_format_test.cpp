// .pmf: a lone mesh as a scene, and scenes as meshes.
#include "convert/framing.h"
#include "convert/pmf_format.h"
#include "tests/convert/support.h"
#include "yarte/lang/pmf.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace yarte::convert::test {
namespace {

const std::filesystem::path buck = std::filesystem::path(YARTE_SOURCE_DIR) / "scenes/paper/buck.pmf";

std::optional<MeshData> meshIn(const std::string& text) {
    Sources sources;
    Diagnostics diagnostics;
    return parsePmf(sources.add("out.pmf", text), sources, diagnostics);
}

TEST(Framing, SeesEveryVertex) {
    for (unsigned seed = 1; seed <= 20; ++seed) {
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> place(-1e3, 1e3), size(0.001, 1e3), side(-1, 1);
        const Vec3 centre{place(random), place(random), place(random)};
        const double scale = size(random);
        MeshData mesh;
        for (int i = 0; i < 30; ++i)
            mesh.vertices.push_back(centre + Vec3{side(random), side(random), side(random)} * scale);
        Ledger ledger;
        const Camera camera = sceneAround(mesh, ledger).camera;
        const Vec3 forward = normalised(camera.focus - camera.position);
        const double halfAngle = camera.horizontalApertureDegrees * std::numbers::pi / 180;
        EXPECT_EQ(camera.horizontalApertureDegrees, camera.verticalApertureDegrees);
        for (const Vec3 v : mesh.vertices)
            EXPECT_GT(dot(normalised(v - camera.position), forward), std::cos(halfAngle)) << "seed " << seed;
    }
}

TEST(Framing, TellsWhatItAdded) {
    const Converted run(options(buck, "out.yarte"));
    EXPECT_EQ(summary(run.ledger), "camera|everything|added\n"
                                   "light 1|everything|added\n"
                                   "material 1|everything|added\n"
                                   "mesh 1|file|exact\n"
                                   "scene|everything|exact\n");
    EXPECT_EQ(run.problems(), "");
}

TEST(Framing, GivesAPointARadius) {
    MeshData point;
    point.vertices = {{1, 2, 3}};
    Ledger ledger;
    EXPECT_TRUE(isFinite(sceneAround(point, ledger).camera.position));
}

TEST(Pmf, ToPmfIsTheSameMeshWithoutLoss) {
    const Converted run(options(buck, "out.pmf"));
    ASSERT_EQ(run.files.size(), 1U) << run.problems();
    EXPECT_EQ(meshIn(run.files[0].bytes), meshIn(readFile(buck)));
    EXPECT_FALSE(run.ledger.hasLoss());
}

TEST(Pmf, OfASceneHoldsItsMeshesInTheirPlaces) {
    const Converted run(options(goldenFolder / "meshes.yarte", "out.pmf"));
    ASSERT_EQ(run.files.size(), 1U) << run.problems();
    const auto mesh = meshIn(run.files[0].bytes);
    ASSERT_TRUE(mesh);
    EXPECT_EQ(mesh->faceCount(), 7U);
    EXPECT_EQ(mesh->vertices[1], (Vec3{0.5, 0, 0}));       // flat.pmf's (1, 0, 0) at scale 1.5, moved by -1
    EXPECT_EQ(mesh->vertices[16 + 1], (Vec3{1, 0, 1.25})); // smooth.pmf's (1, 0, 0.25), moved by 1 along z
    EXPECT_FALSE(mesh->isSmooth());
    EXPECT_EQ(summary(run.ledger), "camera|everything|dropped\n"
                                   "light 1|everything|dropped\n"
                                   "material 1|everything|dropped\n"
                                   "bodies' limits|everything|dropped\n"
                                   "faces|vertices|exact\n"
                                   "faces|normals|dropped\n");
}

TEST(Pmf, OfASceneHoldsItsPolygons) {
    const Converted run(options(goldenFolder / "shapes.yarte", "out.pmf"));
    ASSERT_EQ(run.files.size(), 1U) << run.problems();
    const auto mesh = meshIn(run.files[0].bytes);
    ASSERT_TRUE(mesh);
    ASSERT_EQ(mesh->faceCount(), 1U);
    EXPECT_EQ(mesh->vertices.size(), 5U);
}

TEST(Pmf, OfASceneWithoutFacesIsAnError) {
    const Converted run(
        options(std::filesystem::path(YARTE_SOURCE_DIR) / "scenes/gamma/gamma.yarte", "out.pmf"));
    EXPECT_TRUE(run.files.empty());
    EXPECT_EQ(run.problems(),
              "error: the scene has neither a mesh nor a polygon to write [convert.no-mesh]\n");
}

} // namespace
} // namespace yarte::convert::test
