// Verdict: what is said about a case, and from what.
#pragma once

#include "validate/aov.h"
#include "validate/flip.h"
#include "validate/picture.h"
#include "validate/tolerance.h"

#include <stdexcept>
#include <string>
#include <vector>

namespace yarte::validate {

enum class Verdict {
    pass,
    fail, ///< the pictures differ
    error ///< there are no two pictures to compare
};

/// "pass", "fail", "error".
const char* name(Verdict);

/// Of a comparison that found `pixelsOver` pixels above the threshold.
inline Verdict judge(const Tolerance&, std::size_t pixelsOver) {
    return pixelsOver > 0 ? Verdict::fail : Verdict::pass;
}

/// True if a condition speaks of silhouettes: judging needs an AOV.
bool needsAov(const Tolerance&);

/// What is judged: two finite pictures of one size, their FLIP map, and the AOV if there is one.
struct JudgedPictures {
    ImageView a, b;
    const FlipMap& flip;
    const Aov* aov = nullptr;
};

struct Judgement {
    bool holds = false;
    std::string message; ///< which conditions failed and by how much, a line each; else empty
    std::vector<ConditionResult> conditions; ///< all of them, in the order of the file
};

/// The tolerance cannot be applied: a mask is missing or of another size, or there is no AOV.
class JudgementError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// Throws JudgementError.
Judgement judge(const Tolerance&, const JudgedPictures&);

} // namespace yarte::validate
