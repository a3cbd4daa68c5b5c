#include "tests/lang/read_text.h"

#include "tests/support/scenes.h"

#include <gtest/gtest.h>

#include <bit>

namespace yarte {
namespace {

using test::PmfText;

TEST(Pmf, ReadsFacesOfAnySize) {
    const PmfText read("4 2\n0 0 0 1 0 0 1 1 0 0 1 0\n0 1 2 ; a triangle\n\n0 1 2 3;a square\n");
    ASSERT_EQ(read.messages(), "");
    EXPECT_EQ(read.mesh->vertices, (std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}));
    EXPECT_EQ(read.mesh->faceStarts, (std::vector<std::uint32_t>{0, 3, 7}));
    EXPECT_EQ(read.mesh->corners, (std::vector<std::uint32_t>{0, 1, 2, 0, 1, 2, 3}));
    EXPECT_FALSE(read.mesh->isSmooth());
    EXPECT_EQ(read.mesh->path, "");
}

TEST(Pmf, LineEndsMayBeCrlfAndTheLastMayBeMissing) {
    const PmfText unix("3 1\n0 0 0\n1 0 0\n0 1 0\n0 1 2\n"), dos("\xEF\xBB\xBF"
                                                                 "3 1\r\n0 0 0\r\n1 0 0\r\n0 1 0\r\n0 1 2");
    ASSERT_EQ(dos.messages(), "");
    EXPECT_EQ(*dos.mesh, *unix.mesh);
}

TEST(Pmf, CoordinatesTakeEveryNotation) {
    const PmfText read("3 1 +1. .5 -1e-400 1e+2 -0 5e-324 0 1 0 0 1 2\n");
    EXPECT_NE(read.messages(), ""); // the counts have a line of their own
    const PmfText good("3 1\n+1. .5 -1e-400 1e+2 -0 5e-324 0 1 0\n0 1 2\n");
    ASSERT_EQ(good.messages(), "");
    EXPECT_EQ(good.mesh->vertices, (std::vector<Vec3>{{1, 0.5, 0}, {100, 0, 5e-324}, {0, 1, 0}}));
    EXPECT_TRUE(std::signbit(good.mesh->vertices[0].z));
    EXPECT_TRUE(std::signbit(good.mesh->vertices[1].y));
}

TEST(Pmf, NormalsMakeItSmooth) {
    const PmfText read("3 1\n0 0 0\n1 0 0\n0 1 0\n0 1 2\nnormals 2\n0 0 1\n0 3 4\nface_normals\n0 1 0\n");
    ASSERT_EQ(read.messages(), "");
    EXPECT_TRUE(read.mesh->isSmooth());
    EXPECT_EQ(read.mesh->normals, (std::vector<Vec3>{{0, 0, 1}, {0, 3, 4}})); // as written
    EXPECT_EQ(read.mesh->cornerNormals, (std::vector<std::uint32_t>{0, 1, 0}));
}

TEST(Pmf, MissingFileIsADiagnostic) {
    Sources sources;
    Diagnostics diagnostics;
    EXPECT_FALSE(readPmf("no/such.pmf", {}, sources, diagnostics));
    EXPECT_EQ(format(diagnostics, sources, DiagnosticStyle::plain),
              "no/such.pmf: error: cannot read the file: no such file or directory [pmf.unreadable]\n");
}

TEST(Pmf, ErrorsAreLimited) {
    std::string text = "3 1000\n0 0 0\n1 0 0\n0 1 0\n";
    for (int i = 0; i < 1000; ++i) text += "7 8 9\n";
    const PmfText read(text);
    EXPECT_EQ(read.diagnostics.all().size(), 20U);
    EXPECT_TRUE(read.diagnostics.full());
}

/// Faces over random vertices; triangles unless each face is a planar quadrilateral.
MeshData randomMesh(test::Random& random, bool smooth) {
    MeshData mesh;
    const int vertexCount = 3 + random.below(50);
    for (int i = 0; i < vertexCount; ++i)
        mesh.vertices.push_back(random.inCube(1) * std::pow(10, random.below(40) - 20));
    for (int f = 1 + random.below(50); f > 0; --f) {
        for (int corner = 0; corner < 3; ++corner)
            mesh.corners.push_back(static_cast<std::uint32_t>(random.below(vertexCount)));
        mesh.faceStarts.push_back(static_cast<std::uint32_t>(mesh.corners.size()));
    }
    if (!smooth) return mesh;
    for (int i = 0; i < 7; ++i) mesh.normals.push_back(random.direction());
    for (std::size_t i = 0; i < mesh.corners.size(); ++i)
        mesh.cornerNormals.push_back(static_cast<std::uint32_t>(random.below(7)));
    return mesh;
}

TEST(Pmf, PrintedMeshesReadBackBitForBit) {
    constexpr unsigned seed = 3;
    test::Random random(seed);
    for (int i = 0; i < 200; ++i) {
        MeshData mesh = randomMesh(random, i % 2 == 0);
        mesh.vertices[0].x = -0.0;
        const std::string text = printPmf(mesh);
        const PmfText read(text);
        ASSERT_EQ(read.messages(), "") << "seed " << seed << ", mesh " << i;
        EXPECT_EQ(*read.mesh, mesh);
        EXPECT_EQ(printPmf(*read.mesh), text);
    }
}

} // namespace
} // namespace yarte
