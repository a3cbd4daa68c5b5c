// Small programs that ask for much: each ends with an error, soon and with little memory.
#include "tests/convert/povray/sdl/run.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace yarte::convert::povray::sdl::test {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

std::string repeated(int times, const std::string& text) {
    std::string all;
    for (int i = 0; i < times; ++i) all += text;
    return all;
}

std::string problemsOf(const std::string& text, const Limits& limits = {}) {
    return SdlRun(text, "scene.pov", limits).problems();
}

TEST(SdlBudget, FunctionsThatCallEachOtherTwice) {
    const auto doubled = [](int times) {
        return "#declare f = function(x) { x }\n" +
               repeated(times, "#declare f = function(x) { f(x) + f(x) }\n") + "sphere { 0, f(1) }\n";
    };
    EXPECT_THAT(problemsOf(doubled(10)), IsEmpty());
    EXPECT_THAT(problemsOf(doubled(100)), HasSubstr("[sdl.function]"));
}

TEST(SdlBudget, TheStackOfAFunction) {
    const auto sum = [](int terms) {
        return "#declare f = function(x) { " + repeated(terms - 1, "x+") + "x }\n";
    };
    EXPECT_THAT(problemsOf(sum(2000)), IsEmpty());
    EXPECT_THAT(problemsOf(sum(2001)), HasSubstr("[sdl.function]"));
    EXPECT_THAT(problemsOf(sum(200'000)), HasSubstr("[sdl.function]"));
    EXPECT_THAT(problemsOf("#declare f = function(x) { x }\n" +
                           repeated(100'000, "#declare f = function(x) { f(x) }\n")),
                HasSubstr("[sdl.function]"));
}

TEST(SdlBudget, CallsCountAsWords) {
    Limits limits;
    limits.tokens = 100'000;
    const std::string text =
        "#declare f = function(x) { " + repeated(999, "x+") + "x }\n" +
        "#declare i = 0;\n#while (i < 200) #declare Value = f(i); #declare i = i + 1; #end\n";
    EXPECT_THAT(problemsOf(text), IsEmpty());
    EXPECT_THAT(problemsOf(text, limits), HasSubstr("[sdl.runs-too-long]"));
}

TEST(SdlBudget, UnionsOfUnions) {
    const auto doubled = [](int times) {
        return "#declare U = sphere { 0, 1 }\n" +
               repeated(times, "#declare U = union { object { U } object { U } }\n") + "object { U }\n";
    };
    EXPECT_THAT(problemsOf(doubled(10)), IsEmpty());
    EXPECT_THAT(problemsOf(doubled(60)), HasSubstr("more than 5000000 objects [sdl.objects]"));
    EXPECT_THAT(problemsOf("#declare U = sphere { 0, 1 }\n" +
                           repeated(100'000, "#declare U = union { object { U } }\n")),
                HasSubstr("more than 500 levels of objects [sdl.too-deep]"));
    Limits limits;
    limits.objects = 10;
    EXPECT_THAT(
        problemsOf("#declare U = union { sphere { 0, 1 } sphere { 1, 1 } }\n" + repeated(3, "object { U }\n"),
                   limits),
        IsEmpty());
    EXPECT_THAT(
        problemsOf("#declare U = union { sphere { 0, 1 } sphere { 1, 1 } }\n" + repeated(4, "object { U }\n"),
                   limits),
        HasSubstr("[sdl.objects]"))
        << "12 with all parts";
}

TEST(SdlBudget, LayersOfLayers) {
    const auto doubled = [](int times) {
        return "#declare T = texture { pigment { rgb 1 } }\n" +
               repeated(times, "#declare T = texture { T } texture { T }\n");
    };
    EXPECT_THAT(problemsOf(doubled(9)), IsEmpty());
    EXPECT_THAT(problemsOf(doubled(60)), HasSubstr("more than 1000 layers [sdl.layers]"));
}

TEST(SdlBudget, ArraysOfArrays) {
    const auto doubled = [](int times) {
        return "#declare A = array[2]\n" + repeated(times, "#declare A = array[2] { A, A }\n");
    };
    EXPECT_THAT(problemsOf(doubled(10)), IsEmpty());
    Limits limits;
    limits.elements = 10'000;
    EXPECT_THAT(problemsOf(doubled(60), limits), HasSubstr("[sdl.array]"));
    EXPECT_THAT(problemsOf("#declare A = array[1]\n" + repeated(2000, "#declare A = array[1] { A }\n")),
                HasSubstr("[sdl.array]"));
}

TEST(SdlBudget, ElementsOfArraysThatAreGoneCountNoMore) {
    Limits limits;
    limits.elements = 1000;
    const std::string loop = "#declare A = array[300]\n#declare i = 0;\n"
                             "#while (i < 50) #declare B = A; #declare i = i + 1; #end\n";
    EXPECT_THAT(problemsOf(loop, limits), IsEmpty());
    EXPECT_THAT(problemsOf(loop + "#declare C = A; #declare D = A;\n", limits), HasSubstr("[sdl.array]"));
}

TEST(SdlBudget, StringsInAll) {
    Limits limits;
    limits.strings = 1000;
    EXPECT_THAT(problemsOf(repeated(10, "#declare S = \"0123456789\";\n"), limits), IsEmpty());
    EXPECT_THAT(problemsOf(repeated(101, "#declare S = \"0123456789\";\n"), limits),
                HasSubstr("strings of more than 1000 bytes in all [sdl.string-too-long]"));
}

} // namespace
} // namespace yarte::convert::povray::sdl::test
