#include "convert/gltf/accessor.h"

#include "yarte/base/huge_pages.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

namespace yarte::convert::gltf {
namespace {

static_assert(std::endian::native == std::endian::little, "components are copied as they lie in the file");

/// The plain integer or float that the component is.
template <class Component>
Component load(const char* bytes) {
    Component value;
    std::memcpy(&value, bytes, sizeof value);
    return value;
}

/// glTF 2.0 section 3.6.2.2: normalised integers are c / max, signed ones at least -1.
template <class Component>
double toDouble(Component value, bool normalised) {
    if constexpr (std::is_floating_point_v<Component>) {
        return value;
    } else {
        if (!normalised) return value;
        return std::max(value / double(std::numeric_limits<Component>::max()), -1.0);
    }
}

/// Calls `visit` with a value of the component's type, which says what type that is.
template <class Visitor>
auto withType(ComponentType type, Visitor visit) {
    switch (type) {
    case ComponentType::int8: return visit(std::int8_t{});
    case ComponentType::uint8: return visit(std::uint8_t{});
    case ComponentType::int16: return visit(std::int16_t{});
    case ComponentType::uint16: return visit(std::uint16_t{});
    case ComponentType::uint32: return visit(std::uint32_t{});
    case ComponentType::float32: break;
    }
    return visit(float{});
}

/// `read(bytes)` for each of `count` elements of a `Component`, in a view that holds them.
template <class Element, class Read>
void readAll(std::string_view bytes, std::size_t count, std::size_t stride, std::vector<Element>& elements,
             Read read) {
    const char* at = bytes.data();
    for (std::size_t i = 0; i < count; ++i, at += stride) elements.push_back(read(at));
}

/// The elements, each made by `read` from its bytes; nothing after reporting why.
template <class Element, class Read>
std::optional<std::vector<Element>> readElements(Content& content, AccessorId id, Read read) {
    const Accessor& accessor = content.document().accessors[id];
    const auto bytes = accessor.view ? content.bytesOf(*accessor.view) : std::string_view();
    // Nothing is reserved before the bytes are known to be there: the file may have claimed any number.
    if (!bytes || !content.takeElements(accessor.count, *accessor.json)) return std::nullopt;
    std::vector<Element> elements;
    if (accessor.view) {
        reserveWhole(elements, accessor.count);
        const std::size_t stride = content.document().views[*accessor.view].stride;
        readAll(bytes->substr(accessor.offset), accessor.count, stride ? stride : accessor.elementSize,
                elements, read);
    } else {
        elements.resize(accessor.count);
    }
    if (!accessor.sparse) return elements;
    const Sparse& sparse = *accessor.sparse;
    const auto indices = content.bytesOf(sparse.indicesView), values = content.bytesOf(sparse.valuesView);
    if (!indices || !values) return std::nullopt;
    for (std::size_t i = 0; i < sparse.count; ++i) {
        const std::size_t index = withType(sparse.indexType, [&](auto component) {
            using Component = decltype(component);
            return static_cast<std::size_t>(
                load<Component>(indices->data() + sparse.indicesOffset + i * sizeof(Component)));
        });
        if (index >= accessor.count) {
            content.errors().report(
                "gltf.bad-reference",
                fmt::format("a sparse index must be below {}, got {}", accessor.count, index), *accessor.json,
                "sparse/indices");
            return std::nullopt;
        }
        elements[index] = read(values->data() + sparse.valuesOffset + i * accessor.elementSize);
    }
    return elements;
}

/// All components of elements that have at most `most` of them.
template <std::size_t most>
std::optional<std::vector<double>> readComponents(Content& content, AccessorId id) {
    const Accessor& accessor = content.document().accessors[id];
    using Element = std::array<double, most>;
    const auto components = static_cast<std::size_t>(accessor.components);
    const auto elements = withType(accessor.type, [&](auto component) {
        using Component = decltype(component);
        return readElements<Element>(content, id, [&](const char* at) {
            Element element{};
            for (std::size_t c = 0; c < components; ++c)
                element[c] = toDouble(load<Component>(at + c * sizeof(Component)), accessor.normalised);
            return element;
        });
    });
    if (!elements) return std::nullopt;
    std::vector<double> numbers;
    reserveWhole(numbers, elements->size() * components);
    for (const Element& element : *elements)
        numbers.insert(numbers.end(), element.begin(), element.begin() + accessor.components);
    return numbers;
}

/// Nothing after an error.
std::nullopt_t notFinite(Content& content, AccessorId id) {
    content.errors().report("gltf.not-finite", "the elements must be finite numbers",
                            *content.document().accessors[id].json);
    return std::nullopt;
}

} // namespace

std::optional<std::vector<Vec3>> readVectors(Content& content, AccessorId id) {
    const Accessor& accessor = content.document().accessors[id];
    auto vectors = withType(accessor.type, [&](auto component) {
        using Component = decltype(component);
        const bool normalised = accessor.normalised;
        return readElements<Vec3>(content, id, [normalised](const char* at) {
            return Vec3{toDouble(load<Component>(at), normalised),
                        toDouble(load<Component>(at + sizeof(Component)), normalised),
                        toDouble(load<Component>(at + 2 * sizeof(Component)), normalised)};
        });
    });
    if (vectors && !std::ranges::all_of(*vectors, isFinite)) return notFinite(content, id);
    return vectors;
}

std::optional<std::vector<double>> readNumbers(Content& content, AccessorId id) {
    auto numbers = content.document().accessors[id].components <= 4 ? readComponents<4>(content, id)
                                                                    : readComponents<16>(content, id);
    if (numbers && !std::ranges::all_of(*numbers, [](double n) { return std::isfinite(n); }))
        return notFinite(content, id);
    return numbers;
}

std::optional<std::vector<std::uint32_t>> readIndices(Content& content, AccessorId id, std::size_t limit) {
    const Accessor& accessor = content.document().accessors[id];
    auto indices = withType(accessor.type, [&](auto component) {
        using Component = decltype(component);
        return readElements<std::uint32_t>(
            content, id, [](const char* at) { return static_cast<std::uint32_t>(load<Component>(at)); });
    });
    if (!indices) return std::nullopt;
    const std::uint32_t largest = *std::ranges::max_element(*indices);
    const std::uint64_t restart = (std::uint64_t{1} << (8 * sizeOf(accessor.type))) - 1;
    if (largest == restart)
        content.errors().report("gltf.primitive-restart",
                                fmt::format("{} would restart the primitive: it must not occur", restart),
                                *accessor.json);
    else if (largest >= limit)
        content.errors().report(
            "gltf.bad-reference",
            fmt::format("an index must be below the number of vertices, {}, got {}", limit, largest),
            *accessor.json);
    else
        return indices;
    return std::nullopt;
}

} // namespace yarte::convert::gltf
