// Samples: pictures as few bytes, for the report's page, which unpacks them in report/samples.js.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace yarte::validate {

/// Integers in [-2^22, 2^22), so that residuals fit three bytes; channels of a pixel side by side, rows from
/// the top.
struct Samples {
    int width = 0, height = 0, channels = 1;
    std::vector<std::int32_t> values; ///< width*height*channels

    std::size_t index(int x, int y, int channel) const;
};

/// A zlib stream. Each sample is predicted by its neighbours, left + above - above left (0 outside), which is
/// exact where light changes evenly. The residual r is written as 2r or -2r - 1, whichever is not negative:
/// first the lowest bytes of all samples, then their middle bytes, then their highest.
std::string pack(const Samples&);

} // namespace yarte::validate
