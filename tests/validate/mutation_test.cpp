#include "tests/validate/mutations.h"
#include "yarte/base/file.h"
#include <gtest/gtest.h>

#include "validate/aov.h"
#include "validate/attribution.h"
#include "validate/image_file.h"
#include "yarte/aov_image.h"
#include "yarte/lang/pmf.h"
#include "yarte/lang/scene_reader.h"

#include <cstdlib>
#include <fmt/format.h>
#include <map>

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

Aov aovOf(const Scene& scene, const Sources& sources) {
    const WorldPtr world = buildWorld(scene, scene.resolution);
    const RenderOptions options{
        {0, 0, scene.resolution.width, scene.resolution.height}, 32, RenderMode::serial, 1};
    const auto image = aovImage(scene, sources, *world, options, {});
    const fs::path file = fs::path(YARTE_TEST_OUTPUT) / "mutation.exr";
    fs::create_directories(file.parent_path());
    writeFile(file, encodeExrLayers(*image));
    return aovFrom(readLayers(file));
}

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
        EXPECT_TRUE(scene);
        scene->resolution = {96, 72};
        list.emplace_back(folder.filename(), *scene);
    }
    for (unsigned seed = 1; seed <= 10; ++seed)
        list.emplace_back(fmt::format("room {}", seed), roomScene(seed));
    return list;
}

TEST(MutationTest, All) {
    std::map<std::string, std::map<std::string, int>> confusion;
    int total = 0, right = 0, redrawn = 0;
    Random random(std::getenv("SEED") ? unsigned(std::atoi(std::getenv("SEED"))) : 1u);
    Sources sources;
    for (const auto& [sceneName, scene] : scenes(sources)) {
        const Picture original = rendered(scene);
        const Aov aov = aovOf(scene, sources);
        for (int k = 0; k < mutationKinds; ++k) {
            std::optional<Mutation> m;
            Picture other;
            std::optional<Difference> difference;
            for (int attempt = 0; attempt < 20; ++attempt) {
                m = mutated(scene, static_cast<MutationKind>(k), random);
                if (!m) break;
                other = rendered(m->scene);
                difference.emplace(original.view(), other.view(), 4.0 / 65535);
                if (difference->count() >= 20) break;
                ++redrawn;
                m.reset();
            }
            if (!m) continue;
            const Finding f = explain(*difference, aov).common.value_or(Finding{});
            const bool good = f.cause == m->cause && (m->body < 0 || f.body == m->body) &&
                              (m->light < 0 || f.light == m->light);
            ++total, right += good;
            ++confusion[name(m->kind)]
                       [fmt::format("{}{}", name(f.cause), f.cause == m->cause && !good ? " (other)" : "")];
            if (!good) {
                fmt::print("{:18} {:16} body {} light {}: {} body {} light {} : {}   count {}\n", sceneName,
                           name(m->kind), m->body, m->light, name(f.cause), f.body.value_or(-1),
                           f.light.value_or(-1), f.explanation, difference->count());
            }
        }
    }
    for (const auto& [kind, row] : confusion) {
        fmt::print("{:18}", kind);
        for (const auto& [cause, n] : row) fmt::print(" {}: {}", cause, n);
        fmt::print("\n");
    }
    fmt::print("{} of {} right, {} redrawn\n", right, total, redrawn);
}

} // namespace
} // namespace yarte::validate::test
