// Edges of a picture by what YARTE knows: where one body ends, where a shadow ends, where a mirror image or
// what is seen through glass changes.
#pragma once

#include "validate/aov.h"

#include <vector>

namespace yarte::validate {

/// By pixel: it or one of its eight neighbours is on the other side of an edge.
struct AovEdges {
    std::vector<bool> outline;  ///< between bodies, or a body and the background
    std::vector<bool> shadow;   ///< on one body, between pixels that different lights reach
    std::vector<bool> mirrored; ///< on one body, between pixels whose mirrored rays meet different bodies
    std::vector<bool> seen;     ///< the same of the transmitted rays
};

AovEdges edgesOf(const Aov&);

/// Pixels at most `distance` (in x and in y) from an edge between bodies; 1: the pixels along the edge
/// itself.
std::vector<bool> nearOutline(const Aov&, int distance);

} // namespace yarte::validate
