// Materials, as far as glTF's metallic-roughness model can show them.
#pragma once

#include "convert/gltf/write_output.h"

#include <vector>

namespace yarte::convert::gltf {

/// One for each material that a body has.
class WrittenMaterials {
public:
    /// `thickness`: of each material's bodies, for viewers that refract; 0: as thin walls.
    WrittenMaterials(const Scene&, const std::vector<double>& thickness, Output&);

    bool isUsed(MaterialId id) const { return indices_[id.index].has_value(); }
    std::size_t indexOf(MaterialId id) const { return *indices_[id.index]; }

private:
    std::vector<std::optional<std::size_t>> indices_;
};

} // namespace yarte::convert::gltf
