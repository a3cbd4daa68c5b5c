// Metrics: how far two pictures of one size are apart. Linear light, 1 = white; computed in double over all
// three channels of all pixels. Both pictures must have the same size, at least one pixel, and finite values.
#pragma once

#include "validate/picture.h"

#include <cstddef>
#include <optional>

namespace yarte::validate {

/// The largest |a - b| of the three channels.
double pixelError(Colour a, Colour b);

struct LargestError {
    double value = 0;
    Pixel at; ///< the first such pixel in reading order
};

/// max |a - b|.
LargestError maxAbs(ImageView a, ImageView b);

/// sqrt(mean((a - b)^2)).
double rmse(ImageView a, ImageView b);

/// Peak signal-to-noise ratio for the peak 1: -20 log10(rmse), in dB; none for equal pictures.
std::optional<double> psnr(double rmse);

/// The number of pixels whose pixelError exceeds `threshold`: a pixel counts once.
std::size_t pixelsOver(ImageView a, ImageView b, double threshold);

struct NonFinite {
    std::size_t count = 0; ///< pixels with a nan or an infinity
    Pixel first;           ///< in reading order
};

/// The pixels that no metric can be computed of.
NonFinite nonFinitePixels(ImageView);

/// The largest value of all channels.
double maxValue(ImageView);

} // namespace yarte::validate
