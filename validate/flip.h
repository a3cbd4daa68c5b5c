// LDR-FLIP: the difference that a person notices when two pictures are shown alternately [Andersson20], per
// pixel in [0, 1]. Constants and check vectors are those of the paper.
#pragma once

#include "validate/picture.h"

#include <numbers>
#include <vector>

namespace yarte::validate {

/// A 0.7 m wide screen of 3840 pixels seen from 0.7 m: the paper's default, 67.02 pixels per degree.
inline constexpr double defaultPixelsPerDegree = 0.7 * (3840 / 0.7) * std::numbers::pi / 180;

struct FlipMap {
    int width = 0, height = 0;
    std::vector<float> values; ///< rows from the top
};

struct FlipSummary {
    double mean = 0, max = 0;
    Pixel maxAt; ///< the first such pixel in reading order
};

/// Both pictures in linear light, clamped to [0, 1] here, of one size. (FLIP reads sRGB pictures and decodes
/// them first: the values before that encoding are the same.)
FlipMap flipMap(ImageView reference, ImageView test, double pixelsPerDegree = defaultPixelsPerDegree);

FlipSummary summary(const FlipMap&);

} // namespace yarte::validate
