// Reads a scene with the installed libraries and says how many bodies it has.
#include "convert/format.h"
#include "yarte/engine/render.h"
#include "yarte/lang/scene_reader.h"
#include "yarte/trace/render_tile.h"

#include <cstdio>

int main(int, char** arguments) {
    yarte::Sources sources;
    yarte::Diagnostics diagnostics;
    const auto scene = yarte::readScene(arguments[1], {}, sources, diagnostics);
    if (!scene || yarte::convert::formats().empty()) return 1;
    const yarte::WorldPtr world = yarte::buildWorld(*scene, {4, 4});
    const auto rendering = yarte::render(
        {{0, 0, 4, 4}, 2, yarte::RenderMode::serial, 0},
        [&](yarte::Tile tile, yarte::Colour* pixels, std::size_t stride, yarte::RayCounts& rays) {
            yarte::renderTile(*world, tile, pixels, stride, rays);
        },
        [](yarte::RenderProgress) { return true; });
    if (!rendering) return 1;
    std::printf("%zu bodies\n", scene->bodies.size());
}
