// POV-Ray's layered textures as one Phong material: what convert/README.md says of them, in code.
#pragma once

#include "convert/povray/sdl/model.h"
#include "convert/povray/sdl/report.h"

namespace yarte::convert::povray::sdl {

/// What a texture's colours depend on besides itself.
struct TextureRules {
    Colour ambientLight{1, 1, 1};
    double languageVersion = 3.7;
};

struct Surface {
    Material material;
    std::vector<Loss> losses;
};

/// `layers` from the bottom up; at least one.
Surface reduce(const Layers& layers, const Interior* interior, const TextureRules&);

} // namespace yarte::convert::povray::sdl
