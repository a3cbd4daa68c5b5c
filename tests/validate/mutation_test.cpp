// Mutations: scenes with one thing changed. Every change has to be found, and nearly every one named rightly.
#include "tests/validate/mutations.h"

#include "validate/aov.h"
#include "validate/attribution.h"
#include "validate/compare.h"
#include "validate/image_file.h"
#include "validate/verdict.h"
#include "yarte/aov_image.h"
#include "yarte/base/file.h"
#include "yarte/lang/pmf.h"
#include "yarte/lang/scene_reader.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <map>
#include <numeric>
#include <stdexcept>

namespace yarte::validate::test {
namespace {

namespace fs = std::filesystem;
using yarte::test::Random;

Picture rendered(const Scene& scene) {
    const WorldPtr world = buildWorld(scene, scene.resolution);
    Picture picture{
        scene.resolution.width, scene.resolution.height,
        std::vector<Colour>(static_cast<std::size_t>(scene.resolution.width * scene.resolution.height))};
    RayCounts rays;
    renderTile(*world, {0, 0, picture.width, picture.height}, picture.pixels.data(),
               static_cast<std::size_t>(picture.width), rays);
    return picture;
}

/// As yarte-validate gets it: written to a file and read again.
Aov aovOf(const Scene& scene, const Sources& sources, unsigned seed) {
    const WorldPtr world = buildWorld(scene, scene.resolution);
    const RenderOptions options{
        {0, 0, scene.resolution.width, scene.resolution.height}, 32, RenderMode::serial, 1};
    const auto image = aovImage(scene, sources, *world, options, {});
    const fs::path file = fs::path(YARTE_TEST_OUTPUT) / fmt::format("mutation{}.exr", seed);
    fs::create_directories(file.parent_path());
    writeFile(file, encodeExrLayers(*image));
    return aovFrom(readLayers(file));
}

/// All of scenes/, and rooms that nobody has chosen; small, so that there can be many.
std::vector<std::pair<std::string, Scene>> scenes(Sources& sources) {
    std::vector<std::pair<std::string, Scene>> list;
    constexpr MeshFormat formats[] = {{".pmf", readPmf}};
    std::vector<fs::path> folders;
    for (const auto& entry : fs::directory_iterator(std::string(YARTE_SOURCE_DIR) + "/scenes"))
        if (entry.is_directory()) folders.push_back(entry.path());
    std::sort(folders.begin(), folders.end());
    for (const fs::path& folder : folders) {
        Diagnostics diagnostics;
        auto scene =
            readScene(folder / (folder.filename().string() + ".yarte"), {{}, formats}, sources, diagnostics);
        if (!scene) throw std::runtime_error("cannot read the scene in " + folder.string());
        scene->resolution = {96, 72};
        list.emplace_back(folder.filename(), *scene);
    }
    for (unsigned seed = 1; seed <= 10; ++seed)
        list.emplace_back(fmt::format("room {}", seed), roomScene(seed));
    return list;
}

/// A change that alters fewer pixels of 96 x 72 is drawn again: nobody could name its cause.
constexpr int fewestPixels = 20;
constexpr int attempts = 20;

/// Counted here, not by what is tested: pixels with a channel that differs by more than the default tolerance.
int differingPixels(const Picture& a, const Picture& b) {
    int count = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        const Colour d = a.pixels[i] + b.pixels[i] * -1.0;
        count += std::max({std::abs(d.r), std::abs(d.g), std::abs(d.b)}) > 4.0 / 65535;
    }
    return count;
}

struct Drawn {
    Mutation mutation;
    Picture picture;
    int pixels = 0;
};

/// A change of that kind that can be seen, if one is found.
std::optional<Drawn> drawn(const Scene& scene, const Picture& original, MutationKind kind, Random& random) {
    for (int i = 0; i < attempts; ++i) {
        std::optional<Mutation> mutation = mutated(scene, kind, random);
        if (!mutation) break;
        Picture picture = rendered(mutation->scene);
        if (const int pixels = differingPixels(original, picture); pixels >= fewestPixels)
            return Drawn{std::move(*mutation), std::move(picture), pixels};
    }
    return std::nullopt;
}

bool passes(const Picture& a, const Picture& b, const Aov& aov) {
    const Tolerance strict;
    const Compared compared = compare({"a", a}, {"b", b}, strict.threshold);
    return judge(strict, {a.view(), b.view(), compared.flip, &aov}).holds;
}

bool names(const Finding& found, const Mutation& m) {
    return found.cause == m.cause && (m.body < 0 || found.body == m.body) &&
           (m.light < 0 || found.light == m.light);
}

class MutationTest : public testing::TestWithParam<unsigned> {};

TEST_P(MutationTest, EachIsDetectedAndNearlyAllAreNamed) {
    int total = 0, right = 0;
    std::string wrong;
    Random random(GetParam());
    Sources sources;
    for (const auto& [sceneName, scene] : scenes(sources)) {
        const Picture original = rendered(scene);
        const Aov aov = aovOf(scene, sources, GetParam());
        for (int k = 0; k < mutationKinds; ++k) {
            const auto change = drawn(scene, original, static_cast<MutationKind>(k), random);
            if (!change) continue;
            const Mutation& m = change->mutation;
            const std::string what = fmt::format("{}, {}", sceneName, name(m.kind));
            EXPECT_FALSE(passes(original, change->picture, aov)) << what;

            const Difference difference(original.view(), change->picture.view(), Tolerance().threshold);
            const Explanation explanation = explain(difference, aov);
            const std::size_t inRegions =
                std::accumulate(explanation.regions.begin(), explanation.regions.end(), std::size_t{0},
                                [](std::size_t sum, const Region& r) { return sum + r.pixels; });
            EXPECT_EQ(inRegions, static_cast<std::size_t>(change->pixels)) << what;

            const Finding found = explanation.common.value_or(Finding{});
            ++total;
            if (names(found, m))
                ++right;
            else
                wrong += fmt::format("{}, body {}, light {}, {} pixels: {} ({})\n", what, m.body, m.light,
                                     change->pixels, name(found.cause), found.explanation);
        }
    }
    const double rate = static_cast<double>(right) / total;
    fmt::print("seed {}: {} changes, {} named rightly, {:.1f} %; the others:\n{}", GetParam(), total, right,
               100 * rate, wrong);
    EXPECT_GE(total, 200);
    EXPECT_GE(rate, 0.95);
}

// Seeds that no limit of the attribution was chosen by.
INSTANTIATE_TEST_SUITE_P(Seeds, MutationTest, testing::Values<unsigned>(YARTE_MUTATION_SEEDS));

TEST(EqualPicturesTest, GiveNoFinding) {
    Sources sources;
    for (const auto& [name, scene] : scenes(sources)) {
        const Picture a = rendered(scene), b = rendered(scene);
        const Aov aov = aovOf(scene, sources, 0);
        EXPECT_TRUE(passes(a, b, aov)) << name;
        const Explanation explanation = explain(Difference(a.view(), b.view(), 0), aov);
        EXPECT_FALSE(explanation.common) << name;
        EXPECT_TRUE(explanation.regions.empty()) << name;
    }
}

} // namespace
} // namespace yarte::validate::test
