// The rules that values of a scene must obey, one function per thing that has rules. Readers of every format
// call them: the scene language points at the argument, the converters at a JSON pointer or a place in SDL.
#pragma once

#include "yarte/scene/scene.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace yarte {

struct Problem {
    std::string_view code; ///< as Diagnostic::code
    std::string message;
    int argument =
        -1; ///< index of the scene-language argument at fault (from 0); -1: the directive as a whole
    int argumentCount = 1; ///< how many arguments, from `argument` on, are meant
};

using Problems = std::vector<Problem>;

Problems check(const Resolution&);
Problems check(const Light&);
Problems check(const Material&);
Problems check(const BackColours&);
Problems check(const Referential&);
Problems check(const Shape&);
Problems check(const MeshData&); ///< `argument` is the index of the face at fault
/// Rules between the camera's parts (position, focus, up): argument 0, 1, 2 names the part.
Problems check(const Camera&);

/// Polygon and mesh face: distance of the farthest vertex from the plane (D9), relative to the face's size;
/// nothing for fewer than three vertices or no area.
std::optional<double> planarityError(const std::vector<Vec3>& vertices);
inline constexpr double maxPlanarityError = 1e-3;

} // namespace yarte
