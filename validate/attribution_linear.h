// Causes that change a picture linearly: if one of them is to blame, the difference is a known picture times
// a number, and nothing is left over.
#pragma once

#include "validate/aov.h"
#include "validate/attribution_fit.h"
#include "validate/difference.h"
#include "validate/region.h"

#include <optional>
#include <vector>

namespace yarte::validate {

/// Brightness of the whole, background, or one light, if one of them leaves (almost) nothing over.
std::optional<Finding> globalLinearCause(const Difference&, const Aov&);

/// What one body could be blamed for, and how well that explains the pixels that see it.
struct Suspicion {
    Finding finding;
    Fit fit;
};

/// A fit is an explanation if it leaves over at most this part of the pixels that differ.
inline constexpr double explained = 0.03;

/// Transmission, reflection, colours, exponent of a body, as far as it has them, in the order of the number
/// of their parameters: of two good explanations the simpler one is right.
std::vector<Suspicion> suspicions(const Difference&, const Aov&, int body);

} // namespace yarte::validate
