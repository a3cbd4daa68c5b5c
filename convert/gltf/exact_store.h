// What is put into extras, for exact.h to find again. The schema is in convert/README.md.
#pragma once

#include "convert/gltf/exact.h"

#include <cstddef>
#include <vector>

namespace yarte::convert::gltf {

// `order` is the element's index among the scene's; the other arguments are what the element shows.

Json extrasOf(const Body&, std::size_t order, const Transform& world, const GeometryPrint&);
Json extrasOf(const Light&, std::size_t order, const ShownLight&);
Json extrasOf(const Camera&, const Transform& world, double yfov, double aspectRatio);
Json extrasOf(const Material&, std::size_t order, const PbrMaterial& shown);

/// `isUsed`, `isSaid`: by material, by mesh; a mesh is said if its primitive alone tells it to the last bit.
Json extrasOf(const Scene&, const std::vector<bool>& isUsed, const std::vector<bool>& isSaid);

/// What a material shows, value by value; the names are those of PbrMaterial.
std::vector<Json::Member> shownValues(const PbrMaterial&);

} // namespace yarte::convert::gltf
