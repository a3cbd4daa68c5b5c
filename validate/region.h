// Region: pixels that differ and lie together, with the cause that was found. Plain data for reports.
#pragma once

#include "validate/picture.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace yarte::validate {

/// Why two pictures of a scene differ. The README's "Causes" says how each is told from the others.
enum class Cause {
    unknown,
    brightness, ///< every value times one factor
    camera,     ///< every outline moved: position, focus, aperture
    background,
    light,      ///< one light's place, brightness or colour
    body,       ///< a body is missing, moved or of another size
    shading,    ///< a body's ambient, diffuse or specular colour, or its exponent, on its front or back
    reflection, ///< a mirroring body, or what it mirrors
    refraction, ///< a transmissive body, or what is seen through it
    silhouette, ///< single pixels along outlines: the hit decided the other way
    shadowEdge, ///< single pixels along the edge of a shadow
};

/// For programs: "brightness", "camera", ..., "shadow-edge".
const char* name(Cause);

/// What was found out about a cause; nothing else of a scene need be known to show it.
struct Finding {
    Cause cause = Cause::unknown;
    std::optional<int> body;  ///< index of the scene's body at fault, in the order of the file
    std::optional<int> light; ///< index of the scene's light at fault
    std::string subject;      ///< "sphere at line 23", "light at line 9"; empty if it is no one thing
    int line = 0;             ///< of the subject in the scene's file, from 1; 0: none
    std::string
        explanation; ///< one sentence without a full stop: "the sphere at line 23 is missing or moved"
};

/// Pixels [x0, x1) x [y0, y1).
struct PixelBox {
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
    friend constexpr bool operator==(const PixelBox&, const PixelBox&) = default;
};

struct Region {
    PixelBox box;
    std::size_t pixels = 0; ///< that differ
    double maxError = 0;    ///< linear light
    Pixel maxErrorAt;       ///< the first such pixel in reading order
    Finding finding;
};

/// All that was found out about the difference of two pictures.
struct Explanation {
    /// The one cause that explains all regions, if there is one.
    std::optional<Finding> common;
    std::vector<Region> regions; ///< the most pixels first
};

} // namespace yarte::validate
