// Fitting a difference by known pictures: if a property of the scene changed by k, and the picture is linear
// in it, the difference is k times the property's own picture.
#pragma once

#include "validate/difference.h"

#include <cstddef>
#include <vector>

namespace yarte::validate {

/// What one unit of a property adds to each of the pixels that are fitted.
using Column = std::vector<Colour>;

struct Fit {
    std::vector<Colour> factors; ///< by column
    /// Pixels left over by the fit, as a part of the pixels that differ: 0 is a perfect explanation. (Above 1
    /// a fit that spoils pixels that did not differ.)
    double leftover = 1;
    /// The same by energy: the sum of squares that the fit leaves, as a part of that of the difference.
    double unexplained = 1;
};

/// Least squares over `pixels`, each channel on its own. A pixel is left over if what the fit does not
/// explain exceeds the threshold and 2 % of its error: a small nonlinearity is no other cause.
Fit fitChannels(const Difference&, const std::vector<std::size_t>& pixels, const std::vector<Column>&);

/// The same with one factor for all three channels.
Fit fitGrey(const Difference&, const std::vector<std::size_t>& pixels, const Column&);

} // namespace yarte::validate
