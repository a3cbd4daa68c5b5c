#include "yarte/trace/supersample.h"

#include "tests/support/scenes.h"

#include <gtest/gtest.h>

using namespace yarte;

namespace {

Scene scene() {
    Scene result = test::mixedScene(60, 4);
    result.camera.position = {1, 2, 25};
    result.maxRecursion = 2;
    result.lights.push_back({{20, 30, 25}, {0.6, 0.5, 0.4}, {}});
    return result;
}

TEST(Supersample, APixelIsTheMeanOfItsSamples) {
    for (const int samples : {1, 2, 3, 5, 70}) { // 70: more than a block of the tracer
        const int width = samples < 70 ? 20 : 2, height = samples < 70 ? 15 : 1;
        const WorldPtr fine = buildWorld(scene(), {width * samples, height * samples});
        std::vector<Colour> large(static_cast<std::size_t>(width * samples * height * samples));
        RayCounts counts, largeCounts;
        renderTile(*fine, {0, 0, width * samples, height * samples}, large.data(),
                   static_cast<std::size_t>(width * samples), largeCounts);
        std::vector<Colour> pixels(static_cast<std::size_t>(width * height));
        supersample(
            samples, {0, 0, width, height}, pixels.data(), static_cast<std::size_t>(width),
            [&](Tile tile, Colour* to, std::size_t stride) { renderTile(*fine, tile, to, stride, counts); });
        EXPECT_EQ(counts, largeCounts);
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                Colour sum;
                for (int j = 0; j < samples; ++j)
                    for (int i = 0; i < samples; ++i)
                        sum += large[static_cast<std::size_t>((y * samples + j) * width * samples +
                                                              x * samples + i)];
                EXPECT_EQ(pixels[static_cast<std::size_t>(y * width + x)], sum * (1.0 / (samples * samples)))
                    << samples << " samples, pixel " << x << ' ' << y;
            }
    }
}

TEST(Supersample, TilesDoNotShow) {
    const WorldPtr fine = buildWorld(scene(), {40 * 3, 30 * 3});
    std::vector<Colour> whole(40 * 30), part(40 * 30);
    const auto renderFine = [&](Tile tile, Colour* to, std::size_t stride) {
        RayCounts counts;
        renderTile(*fine, tile, to, stride, counts);
    };
    supersample(3, {0, 0, 40, 30}, whole.data(), 40, renderFine);
    for (int y = 0; y < 30; y += 7)
        for (int x = 0; x < 40; x += 9)
            supersample(3, {x, y, std::min(x + 9, 40), std::min(y + 7, 30)},
                        &part[static_cast<std::size_t>(y * 40 + x)], 40, renderFine);
    EXPECT_EQ(part, whole);
}

} // namespace
