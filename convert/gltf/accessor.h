// The elements of accessors: any component type, normalised or not, interleaved, sparse (glTF 2.0
// section 3.6.2).
#pragma once

#include "convert/gltf/content.h"

namespace yarte::convert::gltf {

// Each gives nothing after reporting why; numbers are finite.

/// Of three components, or the first three of four.
std::optional<std::vector<Vec3>> readVectors(Content&, AccessorId);

/// All components, one after the other.
std::optional<std::vector<double>> readNumbers(Content&, AccessorId);

/// Unsigned scalars, each below `limit`.
std::optional<std::vector<std::uint32_t>> readIndices(Content&, AccessorId, std::size_t limit);

} // namespace yarte::convert::gltf
