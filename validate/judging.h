// Judging a case: both pictures compared, its tolerance applied, and what differs explained.
#pragma once

#include "validate/aov.h"
#include "validate/compare.h"
#include "validate/flip.h"
#include "validate/report.h"
#include "validate/tolerance.h"

#include <functional>

namespace yarte::validate {

/// Makes the AOV of a picture's scene; throws CaseError or ImageError. Empty: nothing is known of a scene.
using AovSource = std::function<Aov()>;

/// Fills in the report's numbers, conditions, causes, verdict and message; its size and exposure must be set.
/// The AOV is made only if pixels differ or the tolerance speaks of outlines. Returns the pictures' FLIP.
/// Throws CaseError if they cannot be compared or the tolerance cannot be applied. `makeAov` is of a's scene,
/// and `makeOlderAov` of b's if that is an older state of the same scene; what it lacks may be lacking on
/// purpose.
FlipMap judgeCase(CaseReport&, const NamedPicture& a, const NamedPicture& b, const Tolerance&,
                  const AovSource& makeAov, const AovSource& makeOlderAov = {});

} // namespace yarte::validate
