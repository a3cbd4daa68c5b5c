#include "yarte/base/number.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <string>

namespace yarte {
namespace {

using Limits = std::numeric_limits<double>;

std::uint64_t bits(double value) { return std::bit_cast<std::uint64_t>(value); }

void expectValue(const std::string& text, double value) {
    const ParsedNumber number = parseNumber(text);
    EXPECT_FALSE(number.error) << text;
    EXPECT_EQ(bits(number.value), bits(value)) << text << " gave " << number.value;
}

void expectError(const std::string& text, NumberError error) {
    const ParsedNumber number = parseNumber(text);
    ASSERT_TRUE(number.error) << text << " gave " << number.value;
    EXPECT_EQ(*number.error, error) << text;
}

TEST(Number, ReadsEveryNotation) {
    expectValue("0", 0.0);
    expectValue("-0", -0.0);
    expectValue("+0.0", 0.0);
    expectValue("200.", 200);
    expectValue(".5", 0.5);
    expectValue("-.5", -0.5);
    expectValue("+1", 1);
    expectValue("007", 7);
    expectValue("1e3", 1000);
    expectValue("1E+3", 1000);
    expectValue("+1.5e-3", 0.0015);
    expectValue("0e999999999999999999999", 0);
    expectValue("-0.000e5", -0.0);
}

TEST(Number, RejectsWhatIsNone) {
    for (const char* text :
         {"",    "+",   "-",     ".",        "e5",  "1e",           "1e+",  "1e+-2", "0x10",
          "nan", "inf", "-inf",  "Infinity", "NAN", "1,5",          "1 ",   " 1",    "--1",
          "+-1", "-+1", "1.2.3", "12abc",    "1f",  "\xEF\xBC\x91", "1_000"})
        expectError(text, NumberError::notANumber);
    expectError(std::string("1\0", 2), NumberError::notANumber);
}

TEST(Number, TooLargeIsOutOfRange) {
    for (const std::string text :
         {"1e999", "-1e999", "1e309", "1.8e308", "1.7976931348623159e308", "1e99999999999999999999",
          "10e9223372036854775807", "123e4611686018427387904"})
        expectError(text, NumberError::outOfRange);
    expectError(std::string(400, '9'), NumberError::outOfRange);
    expectError("." + std::string(90, '0') + "1e400", NumberError::outOfRange);
}

TEST(Number, LargestDoubleIsInRange) {
    expectValue("1.7976931348623157e308", Limits::max());
    expectValue("-1.7976931348623157e308", -Limits::max());
    expectValue("1.79769313486231580793e308", Limits::max()); // rounds down
}

TEST(Number, TooSmallIsTheNearestDouble) {
    expectValue("1e-400", 0.0);
    expectValue("-1e-400", -0.0);
    expectValue("0." + std::string(400, '0') + "1", 0.0);
    expectValue("1e-99999999999999999999", 0.0);
    expectValue("0.1e-9223372036854775807", 0.0);
    expectValue("4.9406564584124654e-324", Limits::denorm_min());
    expectValue("2.4703282292062328e-324", Limits::denorm_min());    // a little above half of it
    expectValue("2.4703282292062327e-324", 0.0);                     // a little below
    expectValue("2.2250738585072011e-308", 0x0.fffffffffffffp-1022); // the largest denormal
    expectValue("2.2250738585072014e-308", Limits::min());
}

TEST(Number, ManyDigitsAreRoundedCorrectly) {
    expectValue("1" + std::string(300, '0'), 1e300);
    expectValue("0." + std::string(300, '3'), 1.0 / 3);
    // 1 + 2^-53 lies half-way between 1 and the next double: to even; a digit 400 places later decides.
    const std::string half = "1.00000000000000011102230246251565404236316680908203125";
    expectValue(half, 1.0);
    expectValue(half + std::string(400, '0') + "1", 1.0 + Limits::epsilon());
    expectValue("9007199254740993", 9007199254740992.0);
}

TEST(Number, PrintsTheShortestText) {
    EXPECT_EQ(printNumber(0.1), "0.1");
    EXPECT_EQ(printNumber(-0.0), "-0");
    EXPECT_EQ(printNumber(45), "45");
    EXPECT_EQ(printNumber(1e22), "1e+22");
    EXPECT_EQ(printNumber(5e-324), "5e-324");
    EXPECT_EQ(printNumber(Limits::max()), "1.7976931348623157e+308");
}

TEST(Number, PrintedNumbersReadBackBitForBit) {
    constexpr unsigned seed = 1;
    std::mt19937_64 random(seed);
    for (int i = 0; i < 200000; ++i) {
        const auto value = std::bit_cast<double>(random()); // denormals and huge ones included
        if (!std::isfinite(value)) continue;
        const std::string text = printNumber(value);
        ASSERT_LE(text.size(), 24U);
        const ParsedNumber number = parseNumber(text);
        ASSERT_FALSE(number.error) << text;
        ASSERT_EQ(bits(number.value), bits(value)) << text << ", seed " << seed;
    }
}

} // namespace
} // namespace yarte
