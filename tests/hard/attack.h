// Attacks: random rays that pass, or start, as near to a decision as doubles allow.
#pragma once

#include "tests/hard/check.h"
#include "tests/support/scenes.h"

#include <string_view>
#include <vector>

namespace yarte::hard {

/// The kinds of shapes that can be attacked, by their names in the scene language; a mesh's faces are
/// polygons.
std::vector<std::string_view> attackedShapes();

/// A shape of any size, place and turn, and a ray past one of its edges, along its surface, into its tip, or
/// from next to it: off by anything between 1e-17 and 1e-2 of its size. A part of them is anywhere, and a
/// part is in short numbers along axes.
Case attack(std::string_view shape, test::Random&);

} // namespace yarte::hard
