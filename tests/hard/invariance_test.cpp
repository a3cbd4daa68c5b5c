// What a picture does not depend on: the unit of length, where the scene lies, how it is turned. All scenes
// of the project and all labelled ones, in small pictures.
#include "tests/hard/transform.h"
#include "tests/support/scene_files.h"

#include "yarte/engine/render.h"
#include "yarte/lang/scene_reader.h"
#include "yarte/trace/lanes/lanes.h"
#include "yarte/trace/world.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

using namespace yarte;
using namespace yarte::hard;

namespace {

namespace fs = std::filesystem;

/// Every scene that can be read and whose numbers leave room for being scaled by 2^40, squared.
std::vector<fs::path> sceneFiles() {
    std::vector<fs::path> result;
    for (const std::string& name : test::sceneNames())
        result.push_back(fs::path(YARTE_SOURCE_DIR) / "scenes" / name / (name + ".yarte"));
    for (const auto& entry : fs::directory_iterator(fs::path(YARTE_SOURCE_DIR) / "tests" / "hard" / "scenes"))
        if (entry.path().extension() == ".yarte" && !entry.path().filename().string().starts_with("input-"))
            result.push_back(entry.path());
    std::sort(result.begin(), result.end());
    return result;
}

using Picture = std::vector<Colour>;

Picture pictureOf(const World& world, Resolution resolution, decltype(renderTile)& renderer = renderTile) {
    Picture picture(static_cast<std::size_t>(resolution.width * resolution.height));
    RayCounts counts;
    renderer(world, {0, 0, resolution.width, resolution.height}, picture.data(),
             static_cast<std::size_t>(resolution.width), counts);
    return picture;
}

Picture pictureInProcesses(const World& world, Resolution resolution) {
    auto rendering = render({{0, 0, resolution.width, resolution.height}, 11, RenderMode::processes, 3},
                                  [&](Tile tile, Colour* pixels, std::size_t stride, RayCounts& rays) {
                                      renderTile(world, tile, pixels, stride, rays);
                                  },
                                  {});
    Picture picture;
    const ImageRows rows = rendering->framebuffer.rows();
    for (int y = 0; y < resolution.height; ++y)
        picture.insert(picture.end(), rows.row(y), rows.row(y) + resolution.width);
    return picture;
}

testing::AssertionResult sameBytes(const Picture& got, const Picture& expected) {
    for (std::size_t i = 0; i < got.size(); ++i)
        if (std::memcmp(&got[i], &expected[i], sizeof got[i]) != 0)
            return testing::AssertionFailure()
                   << "pixel " << i << " is " << got[i].r << ' ' << got[i].g << ' ' << got[i].b << ", not "
                   << expected[i].r << ' ' << expected[i].g << ' ' << expected[i].b;
    return testing::AssertionSuccess();
}

class Invariance : public testing::TestWithParam<fs::path> {
protected:
    Invariance() {
        static constexpr MeshFormat formats[] = {{".pmf", readPmf}};
        Sources sources;
        Diagnostics diagnostics;
        auto scene = readScene(GetParam(), {{}, formats}, sources, diagnostics);
        if (!scene) return; // one of the scenes that are refused
        scene_ = *scene;
        resolution_ = {std::min(scene->resolution.width, 32), std::min(scene->resolution.height, 32)};
        picture_ = picture(scene_);
    }
    ~Invariance() override { trace::forceLaneTarget(""); }
    bool isRefused() const { return picture_.empty(); }
    Picture picture(const Scene& scene) const {
        return pictureOf(*buildWorld(scene, resolution_), resolution_);
    }

    /// `got` is off by no more than four times what coordinates that are `by` off make of the picture.
    void expectAsGood(const Picture& got, double by) const {
        std::vector<double> allowed(picture_.size());
        const auto difference = [](Colour a, Colour b) {
            return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
        };
        for (unsigned seed = 0; seed < 16; ++seed) {
            test::Random random(seed);
            const Picture off = picture(nudged(scene_, by, random));
            for (std::size_t i = 0; i < off.size(); ++i)
                allowed[i] = std::max(allowed[i], 4 * difference(off[i], picture_[i]));
        }
        for (std::size_t i = 0; i < got.size(); ++i)
            EXPECT_LE(difference(got[i], picture_[i]), allowed[i] + 1e-13) << "pixel " << i;
    }

    Scene scene_;
    Resolution resolution_;
    Picture picture_;
};

TEST_P(Invariance, TheUnitOfLengthDoesNotMatterToABit) {
    if (isRefused()) return;
    for (const int k : {-40, -39, -23, -10, -1, 1, 2, 17, 40}) {
        const WorldPtr world = buildWorld(scaled(scene_, std::ldexp(1, k)), resolution_);
        EXPECT_TRUE(sameBytes(pictureOf(*world, resolution_), picture_)) << "scaled by 2^" << k;
        if (std::abs(k) < 40) continue;
        for (const std::string& target : trace::laneTargets()) {
            trace::forceLaneTarget(target);
            EXPECT_TRUE(sameBytes(pictureOf(*world, resolution_), picture_)) << target;
        }
        trace::forceLaneTarget("");
        World withoutTree = *world;
        withoutTree.tree = {}, withoutTree.lightBuffers.assign(withoutTree.lights.size(), {});
        EXPECT_TRUE(sameBytes(pictureOf(withoutTree, resolution_), picture_)) << "no tree";
        EXPECT_TRUE(sameBytes(pictureOf(*world, resolution_, renderTileReference), picture_)) << "reference";
        EXPECT_TRUE(sameBytes(pictureInProcesses(*world, resolution_), picture_)) << "processes";
    }
}

TEST_P(Invariance, MovedItIsAsGoodAsItsCoordinates) {
    if (isRefused()) return;
    // At 1e7 they have a face in common, and what is then met is not decided: see README.md.
    const bool touch = GetParam().filename().string().starts_with("touching-");
    for (const double far : {1e3, touch ? 1e4 : 1e7})
        expectAsGood(picture(moved(scene_, {far, -0.75 * far, 0.5 * far})),
                     std::max(far, extentOf(scene_).largest) * 0x1p-52);
}

TEST_P(Invariance, TurnedItIsTheSameUpToRounding) {
    if (isRefused()) return;
    constexpr Vec3 (*turns[])(Vec3) = {[](Vec3 v) {
                                           return Vec3{v.z, v.x, v.y};
                                       },
                                       [](Vec3 v) {
                                           return Vec3{v.z, v.y, -v.x};
                                       },
                                       [](Vec3 v) {
                                           return Vec3{v.x, -v.y, -v.z};
                                       }};
    for (const auto& turn : turns)
        expectAsGood(picture(turned(scene_, turn)), extentOf(scene_).largest * 0x1p-52);
}

INSTANTIATE_TEST_SUITE_P(Scenes, Invariance, testing::ValuesIn(sceneFiles()), [](const auto& file) {
    std::string name = file.param.stem().string();
    std::replace_if(
        name.begin(), name.end(), [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); }, '_');
    return name;
});

} // namespace
