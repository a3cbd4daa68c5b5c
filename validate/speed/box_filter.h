// The box filter: a picture's pixels as means of the pixels of a larger one.
#pragma once

#include "validate/picture.h"

namespace yarte::validate {

/// Each pixel is the mean of a square of n x n. The picture's sides must be multiples of n.
Picture boxFiltered(const Picture&, int n);

} // namespace yarte::validate
