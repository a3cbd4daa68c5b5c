// What is read is where, and as large as, other programs say: tests/data/gltf/README.md tells how their
// figures were obtained.
#include "tests/convert/gltf/support.h"

#include "convert/gltf/mesh_reader.h"
#include "yarte/scene/mesh_placement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>

namespace yarte::convert::test {
namespace {

namespace fs = std::filesystem;

const fs::path dataFolder = fs::path(YARTE_SOURCE_DIR) / "tests/data/gltf";

/// Of all triangles in the world.
struct Geometry {
    std::size_t triangles = 0;
    Vec3 low{HUGE_VAL, HUGE_VAL, HUGE_VAL}, high{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
    double area = 0;

    void add(const MeshData& mesh, const std::vector<Vec3>& vertices) {
        for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
            const auto face = mesh.face(f);
            for (const std::uint32_t corner : face) {
                const Vec3 v = vertices[corner];
                low = {std::min(low.x, v.x), std::min(low.y, v.y), std::min(low.z, v.z)};
                high = {std::max(high.x, v.x), std::max(high.y, v.y), std::max(high.z, v.z)};
            }
            const Vec3 a = vertices[face[0]];
            area += length(cross(vertices[face[1]] - a, vertices[face[2]] - a)) / 2;
            ++triangles;
        }
    }
};

struct Expected {
    std::string file; ///< below the corpora's folder gltf; one without a folder lies beside the table
    Geometry geometry;

    bool isOurs() const { return fs::path(file).filename() == file; }
    fs::path path() const { return (isOurs() ? dataFolder : fs::path(YARTE_CORPORA) / "gltf") / file; }
};

std::vector<Expected> table() {
    std::vector<Expected> rows;
    std::ifstream file(dataFolder / "geometry.tsv");
    for (std::string line; std::getline(file, line);) {
        Expected row;
        auto& [triangles, low, high, area] = row.geometry;
        std::istringstream(line) >> row.file >> triangles >> low.x >> low.y >> low.z >> high.x >> high.y >>
            high.z >> area;
        rows.push_back(row);
    }
    return rows;
}

Geometry ofMesh(const fs::path& file) {
    Sources sources;
    Diagnostics diagnostics;
    Geometry result;
    const auto mesh = gltf::readMesh(file, {}, sources, diagnostics);
    if (mesh) result.add(*mesh, mesh->vertices);
    return result;
}

Geometry ofScene(const fs::path& file) {
    Sources sources;
    Diagnostics diagnostics;
    Ledger ledger;
    Conversion c{{sources.add(file, readFile(file)), file, {}}, {}, {}, sources, diagnostics, ledger};
    Geometry result;
    const auto scene = gltf::readScene(c);
    if (!scene) return result;
    for (const Body& body : scene->bodies) {
        const auto& mesh = std::get<Mesh>(body.shape);
        const MeshData& data = scene->meshes[mesh.mesh.index];
        result.add(data, placedVertices(data, mesh));
    }
    return result;
}

/// three.js holds the places of instances in float32.
constexpr double float32 = 0x1p-22;

void expectEqual(const Geometry& ours, const Geometry& theirs, const std::string& what) {
    EXPECT_EQ(ours.triangles, theirs.triangles) << what;
    EXPECT_NEAR(ours.area, theirs.area, float32 * theirs.area) << what;
    const double tolerance = float32 * length(theirs.high - theirs.low);
    for (const auto member : {&Vec3::x, &Vec3::y, &Vec3::z}) {
        EXPECT_NEAR(ours.low.*member, theirs.low.*member, tolerance) << what;
        EXPECT_NEAR(ours.high.*member, theirs.high.*member, tolerance) << what;
    }
}

void expectAllEqual(bool ours, std::size_t least) {
    std::size_t count = 0;
    for (const Expected& row : table()) {
        if (row.isOurs() != ours) continue;
        expectEqual(ofMesh(row.path()), row.geometry, row.file + " as a mesh");
        expectEqual(ofScene(row.path()), row.geometry, row.file + " as a scene");
        ++count;
    }
    EXPECT_GE(count, least);
}

TEST(GltfGeometry, OfFormsThatFewFilesHaveIsWhatOthersSee) { expectAllEqual(true, 1); }

TEST(GltfGeometry, OfTheCorpusIsWhatOthersSee) {
    if (std::string(YARTE_CORPORA).empty()) GTEST_SKIP() << "YARTE_CORPORA names no folder with glTF";
    expectAllEqual(false, 20);
}

} // namespace
} // namespace yarte::convert::test
