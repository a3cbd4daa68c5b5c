// Pictures for people to look at.
#pragma once

#include "validate/picture.h"

#include <cstdint>
#include <vector>

namespace yarte::validate {

/// sRGB, 8 bits a channel, rows from the top.
struct DisplayPicture {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgb; ///< 3*width*height
};

/// Clamped to [0, 1] and sRGB encoded.
DisplayPicture displayPicture(ImageView);

/// Where two pictures of one size differ. A pixel's error e is its largest |a - b| of the three channels;
/// brightness is logarithmic, so that half a 16-bit step and a missing object show in one picture: black for
/// e <= 2^-17, one step brighter each time e doubles, brightest for e >= 1. Errors up to `threshold` are
/// grey, larger ones run from red to yellow.
DisplayPicture differencePicture(ImageView a, ImageView b, double threshold);

} // namespace yarte::validate
