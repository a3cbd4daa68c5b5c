// The rules that values of a scene must obey, one function per thing that has rules. Readers of every format
// call them: the scene language points at the argument, the converters at a JSON pointer or a place in SDL.
#pragma once

#include "yarte/scene/scene.h"

#include <string>
#include <string_view>
#include <vector>

namespace yarte {

struct Problem {
    std::string_view code; ///< as Diagnostic::code
    std::string message;   ///< the rule and the value got
    /// Index (from 0) of the scene language's argument at fault, a mesh's file name not counted; -1: the
    /// directive as a whole.
    int argument = -1;
    int argumentCount = 1; ///< how many arguments, from `argument` on, are meant
};

using Problems = std::vector<Problem>;

inline constexpr int maxSide = 1 << 20;       ///< pixels; whether memory suffices is another question
inline constexpr int maxRecursionLimit = 255; ///< POV-Ray has 256 levels, the primary ray's included
/// Sine of the least angle between up vector and view direction: below it, rounding decides what is up.
inline constexpr double minUpSine = 1e-9;

Problems check(const Resolution&);
Problems check(const Light&);    ///< arguments 3 to 5 are the brightness, also where the text gives it as one
Problems check(const Material&); ///< arguments 13 to 15 are the tint, a directive of its own in the text
Problems checkTint(Colour);
Problems check(const BackColours&);
Problems check(const Referential&);
Problems check(const Shape&);
/// `argument` is the index of the face at fault. Tells about the first few faces only. `faceStarts` must be
/// in order and end at the number of corners, `cornerNormals` be empty or as long as `corners`.
Problems check(const MeshData&);
/// Rules between the camera's parts (position, focus, up): argument 0, 1, 2 names the part.
Problems check(const Camera&);
Problems checkApertures(double horizontalDegrees, double verticalDegrees);
Problems checkBackground(Colour);
Problems checkRecursion(int levels);
Problems checkGamma(double);

} // namespace yarte
