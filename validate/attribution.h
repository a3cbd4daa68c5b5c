// Attribution: the cause of a difference, from both pictures and what YARTE knows of its own. The README's
// "Causes" explains the order of the questions and why.
#pragma once

#include "validate/aov.h"
#include "validate/difference.h"
#include "validate/region.h"

namespace yarte::validate {

/// `aov` is that of picture a, and has its size.
Explanation explain(const Difference&, const Aov& aov);

/// Without knowledge of the scene: regions of unknown cause.
Explanation explain(const Difference&);

/// The single cause that explains all pixels that differ; unknown if there is none.
Finding commonCause(const Difference&, const Aov&);

} // namespace yarte::validate
