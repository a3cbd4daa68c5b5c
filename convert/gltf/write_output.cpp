#include "convert/gltf/write_output.h"

#include "convert/gltf/percent.h"
#include "yarte/base/base64.h"
#include "yarte/base/huge_pages.h"
#include "yarte/base/json.h"
#include "yarte/version.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <limits>
#include <utility>

namespace yarte::convert::gltf {
namespace {

static_assert(std::endian::native == std::endian::little, "buffers are written as they lie in memory");

// Values of glTF 2.0 sections 3.6 and 4.4.
constexpr double componentFloat = 5126, componentUint32 = 5125, targetVertices = 34962, targetIndices = 34963;
constexpr std::uint32_t glbMagic = 0x46546c67, glbVersion = 2, chunkJson = 0x4e4f534a,
                        chunkBinary = 0x004e4942;

void appendNumber(std::string& bytes, std::uint32_t number) {
    bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
}

constexpr std::size_t headerSize = 12, chunkHeaderSize = 8;

constexpr std::size_t paddedSize(std::size_t size) { return (size + 3) / 4 * 4; }

void appendChunk(std::string& bytes, std::uint32_t type, std::string_view content, char padding) {
    appendNumber(bytes, static_cast<std::uint32_t>(paddedSize(content.size())));
    appendNumber(bytes, type);
    bytes += content;
    bytes.append(paddedSize(content.size()) - content.size(), padding);
}

/// One element on a line.
std::string printList(std::span<const Json> list) {
    std::string text;
    for (const Json& item : list) text += (text.empty() ? "\n    " : ",\n    ") + printJson(item);
    return "[" + text + "\n  ]";
}

} // namespace

std::size_t Output::add(const std::string& list, Json element) {
    lists_[list].push_back(std::move(element));
    return lists_[list].size() - 1;
}

std::size_t Output::add(const std::string& extension, const std::string& list, Json element) {
    use(extension);
    Json::Array& all = extensionLists_[extension][list];
    all.push_back(std::move(element));
    return all.size() - 1;
}

std::size_t Output::addAccessor(const void* data, std::size_t size, Json accessor, double target) {
    const std::size_t view = add("bufferViews", object({{"buffer", json(0.0)},
                                                        {"byteOffset", json(binary_.size())},
                                                        {"byteLength", json(size)},
                                                        {"target", json(target)}}));
    binary_.append(static_cast<const char*>(data), size); // all components have four bytes: always aligned
    set(accessor, "bufferView", json(view));
    return add("accessors", std::move(accessor));
}

std::size_t Output::addPositions(const std::vector<Vec3f>& positions) {
    Vec3f low = positions.at(0), high = low;
    for (const Vec3f& p : positions)
        for (std::size_t i = 0; i < 3; ++i)
            low[i] = std::min(low[i], p[i]), high[i] = std::max(high[i], p[i]);
    return addAccessor(positions.data(), positions.size() * sizeof(Vec3f),
                       object({{"type", json("VEC3")},
                               {"componentType", json(componentFloat)},
                               {"count", json(positions.size())},
                               {"min", json(widened(low))},
                               {"max", json(widened(high))}}),
                       targetVertices);
}

std::size_t Output::addNormals(const std::vector<Vec3f>& normals) {
    return addAccessor(normals.data(), normals.size() * sizeof(Vec3f),
                       object({{"type", json("VEC3")},
                               {"componentType", json(componentFloat)},
                               {"count", json(normals.size())}}),
                       targetVertices);
}

std::size_t Output::addIndices(const std::vector<std::array<std::uint32_t, 3>>& triangles) {
    return addAccessor(triangles.data(), triangles.size() * sizeof triangles[0],
                       object({{"type", json("SCALAR")},
                               {"componentType", json(componentUint32)},
                               {"count", json(3 * triangles.size())}}),
                       targetIndices);
}

std::string Output::jsonText(const std::string& bufferUri) const {
    std::string text =
        "{\n  \"asset\": " +
        printJson(object({{"version", json("2.0")}, {"generator", json(std::string("YARTE ") + version)}}));
    if (!extensions_.empty()) {
        Json::Array names;
        for (const std::string& name : extensions_) names.push_back(json(name));
        text += ",\n  \"extensionsUsed\": " + printJson(Json(std::move(names)));
    }
    if (!extensionLists_.empty()) {
        std::string all;
        for (const auto& [extension, lists] : extensionLists_) {
            Json members = object({});
            for (const auto& [name, list] : lists) set(members, name, Json(list));
            all += fmt::format("{}\n    {}: {}", all.empty() ? "" : ",", jsonString(extension),
                               printJson(members));
        }
        text += ",\n  \"extensions\": {" + all + "\n  }";
    }
    text += ",\n  \"scene\": 0";
    for (const char* name : {"scenes", "nodes", "cameras", "materials", "meshes", "accessors", "bufferViews"})
        if (const auto list = lists_.find(name); list != lists_.end())
            text += fmt::format(",\n  \"{}\": {}", name, printList(list->second));
    if (!binary_.empty()) {
        Json buffer = object({{"byteLength", json(binary_.size())}});
        if (!bufferUri.empty()) set(buffer, "uri", json(bufferUri));
        text += fmt::format(",\n  \"buffers\": [{}]", printJson(buffer));
    }
    return text + "\n}\n";
}

std::vector<OutputFile> Output::asGltf(const std::filesystem::path& file) const {
    if (binary_.empty()) return {{file, jsonText({})}};
    if (file.empty()) return {{file, jsonText("data:application/octet-stream;base64," + base64(binary_))}};
    const std::filesystem::path beside = file.stem().concat(".bin");
    return {{file, jsonText(percentEncoded(beside.string()))}, {file.parent_path() / beside, binary_}};
}

std::vector<OutputFile> Output::asGlb(const std::filesystem::path& file) const {
    const std::string text = jsonText({});
    std::size_t size = headerSize + chunkHeaderSize + paddedSize(text.size());
    if (!binary_.empty()) size += chunkHeaderSize + paddedSize(binary_.size());
    if (size > std::numeric_limits<std::uint32_t>::max()) return {};
    std::vector<OutputFile> files{{file, {}}};
    std::string& bytes = files[0].bytes;
    reserveWhole(bytes, size);
    appendNumber(bytes, glbMagic);
    appendNumber(bytes, glbVersion);
    appendNumber(bytes, static_cast<std::uint32_t>(size));
    appendChunk(bytes, chunkJson, text, ' ');
    if (!binary_.empty()) appendChunk(bytes, chunkBinary, binary_, '\0');
    return files;
}

} // namespace yarte::convert::gltf
