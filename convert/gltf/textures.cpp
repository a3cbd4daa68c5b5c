#include "convert/gltf/textures.h"

#include <fmt/format.h>

namespace yarte::convert::gltf {
namespace {

/// The element of a root array, by a reference that is reported if it is bad.
std::optional<Object> elementOf(const Json& root, Errors& errors, const char* array, const Object& from,
                                const char* reference, std::uint32_t& id) {
    const Json* all = root.find(array);
    const auto items = all ? all->items() : std::span<const Json>();
    const auto index = from.index(reference, items.size());
    if (!index) return std::nullopt;
    id = *index;
    return Object(items[id], errors);
}

} // namespace

ImageAverage Textures::average(const Object& parent, std::string_view name) {
    const auto reference = parent.object(name);
    if (!reference) return {};
    reference->require("index");
    std::uint32_t id = 0;
    const auto texture = elementOf(asset_.root(), asset_.errors(), "textures", *reference, "index", id);
    if (!texture) return {};
    const auto image = elementOf(asset_.root(), asset_.errors(), "images", *texture, "source", id);
    const std::string where = jsonPointer(asset_.root(), parent.json());
    const ImageAverage average =
        image ? imageAverage(*image, id)
              : ImageAverage{{1, 1, 1}, {1, 1, 1}, 1, "the texture has no image but in an extension"};
    const bool isRead = average.problem.empty();
    ledger_.add({where,
                 std::string(name),
                 isRead ? Action::approximated : Action::dropped,
                 isRead ? "its average stands for the texture" : average.problem,
                 {}});
    // What else a reference says (coordinates, transform, samplers) does not change an average.
    reference->json().markAll(isRead ? Fate::approximated : Fate::unread);
    return average;
}

const ImageAverage& Textures::imageAverage(const Object& image, std::uint32_t id) {
    const auto [entry, isNew] = images_.try_emplace(id);
    if (isNew) entry->second = readImage(image);
    return entry->second;
}

ImageAverage Textures::readImage(const Object& image) {
    if (const auto view = image.index("bufferView", asset_.document().views.size())) {
        const auto bytes = asset_.content().bytesOf(*view);
        return bytes ? averageOf(*bytes) : ImageAverage();
    }
    const Resource file = readUri(image.text("uri"), asset_.content().base());
    if (file.problem.empty()) return averageOf(file.bytes);
    ImageAverage none;
    none.problem = file.problem;
    return none;
}

} // namespace yarte::convert::gltf
