// Verdict: what is said about a case, and from what.
#pragma once

#include <cstddef>

namespace yarte::validate {

enum class Verdict {
    pass,
    fail, ///< the pictures differ
    error ///< there are no two pictures to compare
};

/// "pass", "fail", "error".
const char* name(Verdict);

/// How far pictures may be apart, in linear light.
struct Tolerance {
    double threshold = 4.0 / 65535; ///< a pixel counts as different above this
    std::size_t pixels = 0;         ///< so many may
};

/// Of a comparison that found `pixelsOver` pixels above the threshold.
Verdict judge(const Tolerance&, std::size_t pixelsOver);

} // namespace yarte::validate
