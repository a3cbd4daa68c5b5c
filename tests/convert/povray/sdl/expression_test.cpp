// Expressions have the values that POV-Ray itself prints.
#include "tests/convert/povray/sdl/run.h"
#include "tests/support/povray.h"
#include "tests/support/program.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <random>
#include <sstream>

namespace yarte::convert::povray::sdl::test {
namespace {

/// Strings of one line each; what they show is compared.
std::vector<std::string> written() {
    std::vector<std::string> list;
    const auto numbers = [&](std::initializer_list<const char*> expressions) {
        for (const char* e : expressions) list.push_back(fmt::format("str({}, 0, 12)", e));
    };
    const auto vectors = [&](int n, std::initializer_list<const char*> expressions) {
        for (const char* e : expressions) list.push_back(fmt::format("vstr({}, {}, \" \", 0, 12)", n, e));
    };
    numbers({"1 + 2*3 - 4/5",
             "5 - 3 - 1",
             "-2*-3",
             "2 - -3",
             "-pow(2, 2)",
             "(2*3 = 6 & 1)",
             "(1 | 0 & 0)",
             "!0 + 1",
             "!3",
             "(1 = 1 + 1e-11)",
             "(1 <= 1 - 1e-11)",
             "(1 >= 1 + 1e-11)",
             "(1 < 1 + 1e-11)",
             "(1 > 1 - 1e-11)",
             "(1 != 1 + 1e-9)",
             "(3 > 2 ? 10 : 20)",
             "(0 ? 10 : 20)",
             "(\"abc\" = \"abc\")",
             "(\"abc\" < \"abd\")",
             "(\"b\" > \"abc\")",
             "mod(-7, 3)",
             "mod(7.5, -2)",
             "div(-7, 2)",
             "int(-2.5)",
             "int(2.5)",
             "floor(-2.5)",
             "ceil(-2.5)",
             "abs(-3)",
             "max(1, 5, 3)",
             "min(4, 2, 9)",
             "pow(2, 0.5)",
             "exp(1)",
             "ln(10)",
             "log(1000)",
             "sqrt(2)",
             "sin(1)",
             "cos(1)",
             "tan(1)",
             "asin(0.5)",
             "acos(0.5)",
             "atan2(1, -1)",
             "sinh(1)",
             "cosh(1)",
             "tanh(1)",
             "asinh(1)",
             "acosh(2)",
             "atanh(0.5)",
             "degrees(1)",
             "radians(180)",
             "pi",
             "on + yes + true",
             "off + no + false",
             "select(-1, 10, 20)",
             "select(0, 10, 20)",
             "select(1, 10, 20)",
             "select(-1, 10, 20, 30)",
             "select(0, 10, 20, 30)",
             "select(2, 10, 20, 30)",
             "bitwise_and(12, 10)",
             "bitwise_or(12, 10)",
             "bitwise_xor(12, 10)",
             "asc(\"A\")",
             "strlen(\"hello\")",
             "strcmp(\"a\", \"b\")",
             "val(\"2.5\")",
             "vdot(<1, 2, 3>, <4, 5, 6>)",
             "vlength(<3, 4, 12>)",
             "<1, 2, 3>.y",
             "(<1, 2, 3>*2).z",
             "<1, 2, 3, 4>.t",
             "<1, 2>.u",
             "version",
             "1e3",
             ".5 + 1."});
    vectors(3, {"<1, 2, 3>*<2, 3, 4> + 1", "<1, 2, 3> - x", "2*<1, 2, 3>/4", "-<1, 2, 3>", "vcross(x, y)",
                "vnormalize(<1, 2, 3>)", "vrotate(x, <30, 40, 50>)", "vrotate(<1, 2, 3>, -33*y)",
                "vaxis_rotate(x, <1, 2, 3>, 33)", "<1, 2> + <1, 2, 3>", "x + y*2 + z*3", "(1 = 1 ? x : y)",
                "<pi, exp(1), -1>", "<1 -2 3 4>"});
    vectors(5, {"Color_A", "Color_B", "Color_C", "Color_D", "5*x + t", "Color_A*2 - Color_B"});
    for (const char* e : {"concat(\"a\", \"b\", chr(67))", "strupr(\"aBc\")", "strlwr(\"aBc\")",
                          "substr(\"abcdef\", 2, 3)", "str(1/3, 10, 3)", "str(-1/3, -10, 3)",
                          "str(1/3, 0, -1)", "str(12345678.9, 0, 0)", "str(1e20, 5, 0)"})
        list.emplace_back(e);
    return list;
}

/// Numbers and vectors under operators and functions, by chance.
std::string made(std::mt19937& random, int depth) {
    const auto pick = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
    if (depth == 0) return fmt::format("{}", (pick(2000) - 1000) / 100.0);
    const auto part = [&] { return made(random, depth - 1); };
    switch (pick(10)) {
    case 0: return fmt::format("({} + {})", part(), part());
    case 1: return fmt::format("({} - {})", part(), part());
    case 2: return fmt::format("{}*{}", part(), part());
    case 3: return fmt::format("{}/(1 + abs({}))", part(), part());
    case 4: return fmt::format("sin({})", part());
    case 5: return fmt::format("max({}, {})", part(), part());
    case 6: return fmt::format("<{}, {}, {}>.{}", part(), part(), part(), "xyz"[pick(3)]);
    case 7: return fmt::format("vlength(<{}, {}, {}>)", part(), part(), part());
    case 8: return fmt::format("({} < {} ? {} : {})", part(), part(), part(), part());
    default: return fmt::format("-{}", part());
    }
}

TEST(SdlExpression, HasPovraysValue) {
    if (!yarte::test::hasPovray()) GTEST_SKIP() << "skipped: povray not found";
    std::vector<std::string> expressions = written();
    std::mt19937 random(4);
    for (int i = 0; i < 300; ++i)
        expressions.push_back(fmt::format("str({}, 0, 9)", made(random, 1 + i % 3)));
    for (int i = 0; i < 30; ++i) expressions.push_back("str(rand(Stream), 0, 15)");
    for (const char* kind : {"linear", "quadratic", "natural", "cubic"})
        for (double at = -0.5; at < 5; at += 0.5)
            expressions.push_back(fmt::format("vstr(3, Curve_{}({}), \" \", 0, 9)", kind, at));

    std::string text =
        "#version 3.7;\n#declare Stream = seed(123);\n"
        "#declare Color_A = rgbt <1, 2, 3, 4>*2;\n#declare Color_B = color red 1 green 2 transmit 3;\n"
        "#declare Color_C = color Color_A transmit 5;\n#declare Color_D = rgb <1, 2>;\n";
    for (const char* kind : {"linear", "quadratic", "natural", "cubic"})
        text += fmt::format("#declare Curve_{0} = spline {{ {0}_spline 0, <1, 2, 3> 1, <2, 5, 1> 3, <0, 0, "
                            "2> 4, <5, 1, 1> }}\n",
                            kind);
    // A word of POV-Ray's output may be anywhere: every line has its number.
    for (std::size_t i = 0; i < expressions.size(); ++i)
        text += expressions[i].find("Curve_") == std::string::npos
                    ? fmt::format("#debug concat(\"\\n@{} \", {}, \"\\n\")\n", i, expressions[i])
                    : fmt::format(
                          "#declare P = {}; #debug concat(\"\\n@{} \", vstr(3, P, \" \", 0, 9), \"\\n\")\n",
                          expressions[i].substr(8, expressions[i].find(", \" \"") - 8), i);

    const std::filesystem::path folder = yarte::test::emptyTestFolder();
    writeFile(folder / "scene.pov", text);
    const auto [status, said] = yarte::test::runPovray(folder, "+Iscene.pov -F -D +W4 +H4 -P");
    ASSERT_EQ(status, 0) << said;
    const std::vector<std::string> theirs = markedLines(said);
    const SdlRun run(text);
    ASSERT_TRUE(run.model) << run.problems();
    const std::vector<std::string> ours = markedLines(run.printed);
    ASSERT_EQ(theirs.size(), expressions.size());
    ASSERT_EQ(ours.size(), expressions.size());
    for (std::size_t i = 0; i < ours.size(); ++i) {
        std::istringstream a(ours[i]), b(theirs[i]);
        std::string wordA, wordB;
        while (a >> wordA && b >> wordB) {
            char *endA = nullptr, *endB = nullptr;
            const double x = std::strtod(wordA.c_str(), &endA), y = std::strtod(wordB.c_str(), &endB);
            if (*endA == 0 && *endB == 0) // the last digits depend on the mathematical library
                EXPECT_NEAR(x, y, 1e-9 * (1 + std::abs(y))) << expressions[i];
            else
                EXPECT_EQ(wordA, wordB) << expressions[i];
        }
    }
}

} // namespace
} // namespace yarte::convert::povray::sdl::test
