// YARTE's answers beside the truth.
#pragma once

#include "tests/hard/oracle.h"

#include <string>
#include <vector>

namespace yarte::hard {

/// A ray among the bodies of a scene.
struct Case {
    Scene scene;
    InputRay ray;
};

/// What YARTE makes of a case.
struct Answer {
    bool isRight = true;    ///< hit or miss, which body, which side; true where the truth is not decidable
    std::string wrong;      ///< what is not
    double tError = 0;      ///< in ulps of t, over max(1, condition)
    double normalError = 0; ///< in ulps of 1, over max(1, condition)
};

/// Bound of tError and normalError.
inline constexpr double maxError = 4;
/// Where that many ulps of 1, or an ulp of t, may turn a normal by more than this, next to a tip, nothing is
/// asked of it.
inline constexpr double maxNormalBlur = 0.1;

Answer answer(const Case&, const Truth&);

/// The case as a person can repeat it: the scene's text and the ray in hexadecimal.
std::string toText(const Case&);

/// Of many cases.
struct Score {
    int cases = 0, decidable = 0, hits = 0;
    int wrongDecisions = 0, inexact = 0;
    double worstT = 0, worstNormal = 0;
    std::string examples; ///< the first few that are wrong or inexact

    void add(const Case&);
};

} // namespace yarte::hard
