// PagePixels: what the report's page needs of a case's pictures to show them at any exposure, with their
// values.
#pragma once

#include "validate/flip.h"
#include "validate/picture.h"

#include <cstddef>
#include <string>

namespace yarte::validate {

/// The page's unit of light is a step of a 16-bit file: a value is offset + unit * samples / 65535.
struct PagePixels {
    int width = 0, height = 0; ///< of what is shown; 0: nothing
    int reduction = 1;         ///< the side, in pixels, of the square that is one pixel here
    double offset = 0, unit = 1;
    std::string reference; ///< packed (samples.h): b in steps
    std::string
        difference;   ///< packed: a - b in quarters of a step, 0 below a step; empty: there is one picture
    std::string flip; ///< packed: FLIP times 255; or empty
    std::string thumbnail; ///< PNG, sRGB, 8 bits
};

/// Of two finite pictures of one size and their FLIP. If it takes more than `limit` bytes, squares of 2, 4,
/// ... pixels become one: their mean light, and of their differences the one that is largest, so that no
/// error is hidden.
PagePixels pagePixels(ImageView a, ImageView b, const FlipMap&, std::size_t limit);

/// Of a single picture.
PagePixels pagePixels(ImageView, std::size_t limit);

} // namespace yarte::validate
