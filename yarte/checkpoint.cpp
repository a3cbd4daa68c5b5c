#include "yarte/checkpoint.h"

#include "yarte/base/hash.h"
#include "yarte/base/text.h"
#include "yarte/version.h"

#include <fmt/format.h>

#include <string>
#include <string_view>

namespace yarte {

namespace {

std::string hashOf(std::string_view text) {
    ContentHash hash;
    hash.add(text);
    return hash.hex();
}

std::string hashOf(const MeshData& mesh) {
    ContentHash hash;
    hash.add(mesh.vertices), hash.add(mesh.faceStarts), hash.add(mesh.corners);
    hash.add(mesh.normals), hash.add(mesh.cornerNormals);
    return hash.hex();
}

} // namespace

std::vector<JournalItem> checkpointItems(const Options& options, const Source& sceneText, const Scene& scene,
                                         Resolution size, Tile region) {
    std::vector<JournalItem> items{
        {"the program's version", std::string(version)},
        {"the scene's text", hashOf(sceneText.text())},
    };
    for (const MeshData& mesh : scene.meshes)
        items.push_back({fmt::format("the mesh {}", inQuotes(mesh.path)), hashOf(mesh)});
    items.push_back({"the image's size", fmt::format("{}x{}", size.width, size.height)});
    items.push_back({"--region", fmt::format("{},{},{},{}", region.x0, region.y0, region.x1, region.y1)});
    items.push_back({"--tile", fmt::to_string(*options.tileSide)});
    items.push_back({"--precision", options.precision == Precision::inDouble ? "double" : "fast"});
    items.push_back({"--samples", fmt::to_string(options.samples)});
    return items;
}

} // namespace yarte
