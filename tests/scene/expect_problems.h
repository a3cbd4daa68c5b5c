// What a check function must say, whole.
#pragma once

#include "yarte/scene/check.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace yarte::test {

inline constexpr double infinity = std::numeric_limits<double>::infinity();

/// Expects exactly one problem.
inline void expectProblem(const Problems& got, std::string_view code, const std::string& message,
                          int argument, int argumentCount = 1) {
    ASSERT_EQ(got.size(), 1U) << "for " << code;
    EXPECT_EQ(got[0].code, code);
    EXPECT_EQ(got[0].message, message);
    EXPECT_EQ(got[0].argument, argument);
    EXPECT_EQ(got[0].argumentCount, argumentCount);
}

inline void expectGood(const Problems& got) {
    for (const Problem& problem : got) ADD_FAILURE() << problem.code << ": " << problem.message;
}

} // namespace yarte::test
