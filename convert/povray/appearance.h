// Materials as declared SDL materials: one for each material, and one for each material with back colours.
#pragma once

#include "convert/ledger.h"
#include "yarte/scene/scene.h"

#include <string>
#include <vector>

namespace yarte::convert::povray {

class Appearances {
public:
    explicit Appearances(const Scene&);

    /// The name of the SDL material of a body of the scene, by its index: "Material_3", "Material_3_Back_1".
    const std::string& nameOf(std::size_t body) const { return names_[body]; }

    /// The declarations, one a line.
    const std::string& declarations() const { return declarations_; }

private:
    std::vector<std::string> names_;
    std::string declarations_;
};

/// What the materials lose, if anything. `plain`: as --plain-textures writes them.
void reportMaterials(const Scene&, bool plain, Ledger&);

} // namespace yarte::convert::povray
