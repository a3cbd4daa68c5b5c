// The labelled rays: what is written is true, and YARTE says the same.
#include "tests/hard/suite.h"

#include "yarte/base/file.h"
#include "yarte/trace/search.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace yarte;
using namespace yarte::hard;

namespace {

std::vector<std::filesystem::path> files() {
    std::vector<std::filesystem::path> result;
    for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(YARTE_SOURCE_DIR) /
                                                                 "tests" / "hard" / "rays"))
        if (entry.path().extension() == ".rays") result.push_back(entry.path());
    std::sort(result.begin(), result.end());
    return result;
}

class Rays : public testing::TestWithParam<std::filesystem::path> {};

TEST_P(Rays, LabelsAreTrue) { EXPECT_EQ(labelled(GetParam()), readFile(GetParam())); }

TEST_P(Rays, YarteIsRight) {
    for (const LabelledRay& ray : readRays(GetParam())) {
        const Truth truth = truthOf(ray.problem.scene, ray.problem.ray);
        ASSERT_NE(truth.isDecidable, ray.isTie()) << ray.name;
        if (truth.isDecidable) {
            EXPECT_EQ(answer(ray.problem, truth).wrong, "") << ray.name;
            continue;
        }
        const auto exact = exactTruthOf(ray.problem.scene, ray.problem.ray);
        const WorldPtr world = buildWorld(ray.problem.scene, {1, 1});
        const auto hit = trace::nearestHit(*world, {ray.problem.ray.origin, ray.problem.ray.direction, {}});
        ASSERT_EQ(hit.has_value(), exact.has_value()) << ray.name;
        if (hit) {
            EXPECT_EQ(world->bodyOf(hit->element).index, exact->body) << ray.name;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Families, Rays, testing::ValuesIn(files()),
                         [](const auto& file) { return file.param.stem().string(); });

TEST(Rays, ThereAreEnough) {
    std::size_t count = 0;
    for (const auto& file : files()) count += readRays(file).size();
    EXPECT_GE(count, 300U);
}

} // namespace
