// Removal: bodies that a reference's scene had and the new scene has not. The new scene knows nothing of
// them: what tells is kept with the reference.
#pragma once

#include "validate/aov.h"
#include "validate/difference.h"
#include "validate/image_file.h"
#include "validate/region.h"

#include <optional>
#include <vector>

namespace yarte::validate {

/// Of what `yarte --aov` writes the part that tells which body is seen where, and in whose shadow: a small
/// file. `aovFrom` reads it; lights and colours are left out.
Layers bodiesOnly(const Layers&);

/// Why the reference (a) and the new picture (b) differ, if it is by a body of the reference's scene that is
/// gone: no other body was added or changed its material, and its outline and shadow explain the difference.
/// `reference` is that scene's, `now` are the new scene's bodies.
std::optional<Explanation> explainRemoval(const Difference&, const Aov& reference,
                                          const std::vector<AovBody>& now);

} // namespace yarte::validate
