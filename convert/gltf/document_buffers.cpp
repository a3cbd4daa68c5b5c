// Buffers, their views and the accessors on these.
#include "convert/gltf/document_parts.h"

#include <fmt/format.h>

#include <array>

namespace yarte::convert::gltf {
namespace {

constexpr std::string_view tooLong = "gltf.does-not-fit";

struct ElementType {
    std::string_view name;
    int columns, rows;
};

constexpr ElementType elementTypes[] = {{"SCALAR", 1, 1}, {"VEC2", 1, 2}, {"VEC3", 1, 3}, {"VEC4", 1, 4},
                                        {"MAT2", 2, 2},   {"MAT3", 3, 3}, {"MAT4", 4, 4}};

std::optional<ComponentType> componentType(const Object& object) {
    switch (object.count("componentType", 0)) {
    case 5120: return ComponentType::int8;
    case 5121: return ComponentType::uint8;
    case 5122: return ComponentType::int16;
    case 5123: return ComponentType::uint16;
    case 5125: return ComponentType::uint32;
    case 5126: return ComponentType::float32;
    default: object.error("gltf.bad-component-type", "is none of glTF's component types", "componentType");
    }
    return std::nullopt;
}

BufferView readView(const Object& object, const Document& document) {
    BufferView view;
    view.json = &object.json();
    object.require("buffer");
    object.require("byteLength");
    view.offset = object.count("byteOffset", 0);
    view.length = object.count("byteLength", 0);
    view.stride = object.count("byteStride", 0);
    if (view.length == 0) object.error("gltf.out-of-range", "must not be 0", "byteLength");
    if (object.has("byteStride") && (view.stride < 4 || view.stride > 252 || view.stride % 4 != 0))
        object.error("gltf.out-of-range",
                     fmt::format("must be a multiple of 4 from 4 to 252, got {}", view.stride), "byteStride");
    for (const char* name : {"EXT_meshopt_compression", "KHR_meshopt_compression"})
        if (const Json* all = object.find("extensions"); all && all->find(name)) view.compressed = name;
    if (const auto buffer = object.index("buffer", document.buffers.size())) {
        view.buffer = *buffer;
        // Both are at most 2^53.
        if (view.offset + view.length > document.buffers[*buffer].length)
            object.error(tooLong,
                         fmt::format("bytes {} to {} are not in buffer {}, which has {}", view.offset,
                                     view.offset + view.length, *buffer, document.buffers[*buffer].length));
    }
    return view;
}

/// `count` elements from `offset` on must lie in the view.
void checkFits(const Object& object, const Document& document, std::uint32_t viewId, std::size_t offset,
               std::size_t count, std::size_t elementSize, std::size_t stride) {
    const BufferView& view = document.views[viewId];
    if (stride == 0) stride = elementSize;
    if (stride < elementSize)
        return object.error(tooLong,
                            fmt::format("an element has {} bytes, more than buffer view {}'s stride {}",
                                        elementSize, viewId, stride));
    // An element has a byte at least: what passes the first test cannot overflow in the second.
    if (count > view.length || offset > view.length ||
        offset + (count - 1) * stride + elementSize > view.length)
        object.error(tooLong,
                     fmt::format("{} elements from byte {} on are not in buffer view {}, which has {} "
                                 "bytes",
                                 count, offset, viewId, view.length));
}

std::optional<Sparse> readSparse(const Object& object, const Document& document, const Accessor& accessor) {
    Sparse sparse;
    sparse.count = object.count("count", 0);
    for (const char* name : {"count", "indices", "values"}) object.require(name);
    const auto indices = object.object("indices"), values = object.object("values");
    if (!indices || !values) return std::nullopt;
    for (const Object& part : {*indices, *values}) part.require("bufferView");
    const auto indicesView = indices->index("bufferView", document.views.size());
    const auto valuesView = values->index("bufferView", document.views.size());
    const auto type = componentType(*indices);
    if (sparse.count == 0 || sparse.count > accessor.count) {
        object.error(
            "gltf.out-of-range",
            fmt::format("must be from 1 to the accessor's count {}, got {}", accessor.count, sparse.count),
            "count");
        return std::nullopt;
    }
    if (!indicesView || !valuesView || !type) return std::nullopt;
    if (*type != ComponentType::uint8 && *type != ComponentType::uint16 && *type != ComponentType::uint32) {
        indices->error("gltf.bad-component-type", "must be unsigned", "componentType");
        return std::nullopt;
    }
    sparse.indicesView = *indicesView, sparse.valuesView = *valuesView, sparse.indexType = *type;
    sparse.indicesOffset = indices->count("byteOffset", 0);
    sparse.valuesOffset = values->count("byteOffset", 0);
    checkFits(*indices, document, sparse.indicesView, sparse.indicesOffset, sparse.count, sizeOf(*type), 0);
    checkFits(*values, document, sparse.valuesView, sparse.valuesOffset, sparse.count, accessor.elementSize,
              0);
    return sparse;
}

Accessor readAccessor(const Object& object, const Document& document) {
    Accessor accessor;
    accessor.json = &object.json();
    for (const char* name : {"componentType", "count", "type"}) object.require(name);
    accessor.view = object.index("bufferView", document.views.size());
    accessor.offset = object.count("byteOffset", 0);
    accessor.count = object.count("count", 1);
    accessor.normalised = object.boolean("normalized", false);
    if (accessor.count == 0) object.error("gltf.out-of-range", "must not be 0", "count");
    const auto type = componentType(object);
    const std::string typeName = object.text("type", "SCALAR");
    const ElementType* element = nullptr;
    for (const ElementType& candidate : elementTypes)
        if (candidate.name == typeName) element = &candidate;
    if (!element) object.error("gltf.bad-element-type", "is none of glTF's element types", "type");
    if (!type || !element || accessor.count == 0) return accessor;

    accessor.type = *type;
    accessor.components = element->columns * element->rows;
    const std::size_t column = static_cast<std::size_t>(element->rows) * sizeOf(*type);
    // The columns of a matrix begin at multiples of four bytes.
    accessor.elementSize =
        element->columns == 1 ? column : static_cast<std::size_t>(element->columns) * ((column + 3) / 4 * 4);
    if (accessor.view)
        checkFits(object, document, *accessor.view, accessor.offset, accessor.count, accessor.elementSize,
                  document.views[*accessor.view].stride);
    else if (accessor.count > maxZeros)
        object.error("gltf.too-large",
                     fmt::format("{} elements without a buffer view are too many: at most {}", accessor.count,
                                 maxZeros),
                     "count");
    if (const auto sparse = object.object("sparse"))
        accessor.sparse = readSparse(*sparse, document, accessor);
    return accessor;
}

} // namespace

std::size_t sizeOf(ComponentType type) {
    constexpr std::array<std::size_t, 6> sizes{1, 1, 2, 2, 4, 4};
    return sizes[static_cast<std::size_t>(type)];
}

void readBuffers(const Object& root, Document& document, Errors& errors) {
    for (const Object& object : root.objects("buffers")) {
        object.require("byteLength");
        Buffer buffer;
        buffer.json = &object.json();
        buffer.length = object.count("byteLength", 1);
        if (buffer.length == 0) object.error("gltf.out-of-range", "must not be 0", "byteLength");
        if (const Json* uri = object.find("uri")) {
            buffer.uri = uri->text();
            if (!buffer.uri) object.error("gltf.wrong-type", "must be a string", "uri");
        }
        document.buffers.push_back(buffer);
    }
    for (const Object& object : root.objects("bufferViews"))
        document.views.push_back(readView(object, document));
    if (errors.any()) return; // accessors' checks ask the views
    for (const Object& object : root.objects("accessors"))
        document.accessors.push_back(readAccessor(object, document));
}

} // namespace yarte::convert::gltf
