// Document: what geometry needs of a glTF file, checked: every index names something, every accessor lies in
// its buffer view, every view in its buffer, and the nodes are a forest. Materials, cameras and lights are
// read from the JSON where they are needed.
#pragma once

#include "convert/gltf/object.h"
#include "convert/gltf/transform.h"

#include <map>

namespace yarte::convert::gltf {

enum class ComponentType { int8, uint8, int16, uint16, uint32, float32 };

std::size_t sizeOf(ComponentType);

struct Buffer {
    std::size_t length = 0;
    const std::string* uri = nullptr; ///< none: the binary chunk, if it is the first buffer
    const Json* json = nullptr;
};

struct BufferView {
    std::uint32_t buffer = 0;
    std::size_t offset = 0, length = 0;
    std::size_t stride = 0;           ///< 0: elements follow each other
    const char* compressed = nullptr; ///< the extension that says how the view's content is packed
    const Json* json = nullptr;
};

struct Sparse {
    std::size_t count = 0;
    std::uint32_t indicesView = 0, valuesView = 0;
    std::size_t indicesOffset = 0, valuesOffset = 0;
    ComponentType indexType = ComponentType::uint8;
};

struct Accessor {
    std::optional<std::uint32_t> view; ///< none: zeros
    std::size_t offset = 0, count = 0;
    ComponentType type = ComponentType::float32;
    int components = 1;
    std::size_t elementSize = 0; ///< bytes
    bool normalised = false;
    std::optional<Sparse> sparse;
    const Json* json = nullptr;
};

using AccessorId = std::uint32_t;

struct MorphTarget {
    std::optional<AccessorId> position, normal;
};

enum class Mode { points, lines, lineLoop, lineStrip, triangles, triangleStrip, triangleFan };

struct Primitive {
    Mode mode = Mode::triangles;
    std::optional<AccessorId> position, normal, colour, indices;
    std::vector<AccessorId> joints, weights; ///< sets 0, 1, …; as many of the one as of the other
    std::optional<std::uint32_t> material;
    std::vector<MorphTarget> targets;
    const Json* json = nullptr;

    bool hasTriangles() const { return mode >= Mode::triangles; }
};

struct Mesh {
    std::vector<Primitive> primitives;
    std::vector<double> weights; ///< of the morph targets; empty: 0
    const Json* json = nullptr;
};

/// EXT_mesh_gpu_instancing.
struct Instancing {
    std::optional<AccessorId> translation, rotation, scale;
};

struct Node {
    Transform local;
    std::optional<std::uint32_t> parent, mesh, skin, camera, light;
    std::vector<std::uint32_t> children;
    std::vector<double> weights; ///< instead of the mesh's, if not empty
    std::optional<Instancing> instances;
    bool isVisible = true; ///< KHR_node_visibility: false hides its descendants too
    const Json* json = nullptr;
};

struct Skin {
    std::vector<std::uint32_t> joints;
    std::optional<AccessorId> inverseBindMatrices;
    const Json* json = nullptr;
};

struct Document {
    std::vector<Buffer> buffers;
    std::vector<BufferView> views;
    std::vector<Accessor> accessors;
    std::vector<Mesh> meshes;
    std::vector<Skin> skins;
    std::vector<Node> nodes;
    /// Parents before their children.
    std::vector<std::uint32_t> nodeOrder;
    /// The default scene, otherwise the first; none: every root node is taken.
    std::optional<std::uint32_t> scene;
    std::vector<std::uint32_t> sceneNodes;
};

/// Nothing after reporting what is wrong.
std::optional<Document> readDocument(const Json& root, Errors&);

/// Says by name which of extensionsRequired cannot be read.
void checkRequiredExtensions(const Object& root);

/// Of an accessor without bytes in a buffer, zeros: a file of some bytes must not ask for all memory.
inline constexpr std::size_t maxZeros = std::size_t{1} << 20;

} // namespace yarte::convert::gltf
