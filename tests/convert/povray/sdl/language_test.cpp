// The language itself: directives, macros, names, loops, with values that are known.
#include "tests/convert/povray/sdl/run.h"

#include <gtest/gtest.h>

namespace yarte::convert::povray::sdl::test {
namespace {

TEST(SdlLanguage, ConditionsChooseWhatIsRead) {
    EXPECT_EQ(printedBy(R"(
        #declare A = 3;
        #if (A > 2) #debug "yes" #else #debug "no" #end
        #if (A < 2) #debug "1" #elseif (A = 3) #debug "2" #else #debug "3" #end
        #ifdef (B) #debug "B" #else #declare B = 1; #end
        #ifndef (B) #debug "none" #else #debug "b" #end
        #if (0) #if (1) #debug "x" #else #debug "y" #end #macro M() #end #end)"),
              "yes2b");
}

TEST(SdlLanguage, LoopsAndBreak) {
    EXPECT_EQ(printedBy(R"(
        #declare I = 0;
        #while (I < 10) #debug str(I, 0, 0) #if (I = 3) #break #end #declare I = I + 1; #end
        #for (K, 3, 1, -1) #debug concat(" ", str(K, 0, 0)) #end
        #for (K, 0, 1, 0.25) #end #debug str(K, 0, 2))"),
              "0123 3 2 11.25");
}

TEST(SdlLanguage, SwitchFallsThroughUntilBreak) {
    const std::string text = R"(#macro S(V) #switch (V) #case (1) #debug "a" #case (2) #debug "b" #break
        #range (3, 5) #debug "c" #break #else #debug "d" #end #debug "." #end )";
    EXPECT_EQ(printedBy(text + "S(1) S(2) S(4.5) S(9)"), "ab.b.c.d.");
}

TEST(SdlLanguage, MacrosReturnFragmentsAndTakeNamesByReference) {
    EXPECT_EQ(printedBy(R"(
        #macro Twice(V) (2*V) #end
        #macro Set(Name, V) #declare Name = V; #end
        #declare A = 1; Set(A, Twice(21)) #debug str(A, 0, 0)
        Set(New_One, 7) #debug str(New_One, 0, 0)
        #macro Sum(N) #if (N = 0) 0 #else (N + Sum(N - 1)) #end #end #debug str(Sum(10), 0, 0))"),
              "42755");
}

TEST(SdlLanguage, LocalNamesEndWithTheirMacro) {
    EXPECT_EQ(printedBy(R"(
        #declare A = 1;
        #macro M() #local A = 2; #declare B = A; #declare A = 3; A #end
        #declare C = M(); #debug concat(str(A, 0, 0), str(B, 0, 0), str(C, 0, 0))
        #macro N() #local Q = 5; Q; #end
        #macro P() #local R = N() #if (R = 5) #debug "r" #end #end P())"),
              "123r");
}

TEST(SdlLanguage, ADeclarationIsNotObeyedBeforeTheOneInFrontOfIt) {
    EXPECT_EQ(printedBy("#declare A = 1 #declare B = A + 1 #declare C = B #debug str(C, 0, 0)"), "2");
    const SdlRun run("#declare T = texture { pigment { rgb 1 } } #declare U = texture { T } sphere { 0, 1 "
                     "texture { U } }");
    EXPECT_TRUE(run.model) << run.problems();
}

TEST(SdlLanguage, ArraysAreValuesOfSeveralDimensions) {
    EXPECT_EQ(printedBy(R"(
        #declare A = array[2][3] {{1, 2, 3}, {4, 5, 6}};
        #declare B = A; #declare B[1][2] = 9;
        #debug concat(str(A[1][2], 0, 0), str(B[1][2], 0, 0), str(dimensions(A), 0, 0), str(dimension_size(A, 2), 0, 0))
        #declare E = array[2]; #ifdef (E[1]) #debug "?" #else #debug "-" #end
        #declare N = array[1] {array[2] {<1, 2, 3>, 7}}; #debug str(N[0][1], 0, 0))"),
              "6923-7");
}

TEST(SdlLanguage, AnIncludedFileIsReadWhereItStands) {
    const SdlRun run("#include \"colors.inc\" #debug vstr(3, Orange, \" \", 0, 2)");
    EXPECT_EQ(run.printed, "1.00 0.50 0.00") << run.problems();
}

TEST(SdlLanguage, FunctionsKeepWhatTheyWereMadeOf) {
    EXPECT_EQ(printedBy(R"(
        #declare K = 2; #declare F = function(a, b) { K*a^2 + max(b, 3) - (a < b) };
        #declare K = 100; #declare G = function { F(x, y) + z };
        #debug concat(str(F(3, 1), 0, 0), " ", str(G(1, 5, 0.5), 0, 1)))"),
              "21 6.5");
}

TEST(SdlLanguage, VectorsNeedNoCommas) {
    const SdlRun run(
        "triangle { <0, 2, 0> <0, 0, -1> <1, 0, 0> } cone { <0 0 0> 1 <1 1 1> 2 } sphere { <1 -1 2>, 1 }");
    ASSERT_TRUE(run.model) << run.problems();
    ASSERT_EQ(run.model->objects.size(), 3u);
    // "1 -1" is a subtraction.
    EXPECT_EQ(std::get<SphereShape>(run.model->objects[2]->shape).centre, (Vec3{0, 2, 0}));
}

TEST(SdlLanguage, TransformationsComposeInTheirOrder) {
    const SdlRun run("#declare S = sphere { x, 1 scale 2 } object { S translate <1, 0, 0> rotate 90*y }");
    ASSERT_TRUE(run.model) << run.problems();
    const Vec3 p = mapPoint(run.model->objects[0]->transform, {1, 0, 0});
    EXPECT_NEAR(p.x, 0, 1e-15);
    EXPECT_NEAR(p.z, -3, 1e-15); // left-handed
}

TEST(SdlLanguage, AnObjectsKeywordTakesTheNameOfOne) {
    const SdlRun run("#declare S = sphere { <1, 2, 3>, 4 } sphere { S translate x } union { S S scale 2 }\n"
                     "#declare L = light_source { 1, 1 } light_source { L translate y }");
    ASSERT_TRUE(run.model) << run.problems();
    EXPECT_EQ(std::get<SphereShape>(run.model->objects.at(0)->shape).radius, 4);
    EXPECT_EQ(run.model->objects.at(0)->transform, translation({1, 0, 0}));
    EXPECT_EQ(std::get<UnionShape>(run.model->objects.at(1)->shape).parts.size(), 2U);
    EXPECT_TRUE(std::holds_alternative<LightShape>(run.model->objects.at(2)->shape));
}

/// POV-Ray's shading of the plane y = 0, which is N.L.
TEST(SdlLanguage, ParallelRaysAreParallelToTheirLightsAim) {
    struct Case {
        const char* words;
        double shading;
    };
    for (const Case& c : {Case{"parallel", 0.688},
                          {"parallel point_at <2, 0, 0>", 0.949},
                          {"translate x*3 parallel point_at <2, 0, 0>", 0.6},
                          {"parallel point_at <2, 0, 0> translate x*3", 0.949},
                          {"translate x*3 parallel", 0.688},
                          {"parallel point_at 0 scale <1, 3, 1>", 0.949},
                          {"cylinder point_at 0 radius 100 falloff 120", 0.707},
                          {"spotlight parallel point_at 0 radius 10 falloff 20", 0.707}}) {
        const SdlRun run(std::string("light_source { <3, 3, 0> rgb 1 ") + c.words + " }");
        ASSERT_TRUE(run.model) << run.problems();
        const auto& light = std::get<LightShape>(run.model->objects.at(0)->shape);
        const Vec3 way = normalised(light.position - light.pointAt.value());
        EXPECT_NEAR(way.y, c.shading, 0.0006) << c.words;
    }
}

TEST(SdlLanguage, WhatHasNoShapeIsLeftOutWithItsName) {
    const SdlRun run(
        "difference { sphere { 0, 1 } box { -1, 1 translate x } pigment { rgb 1 } } sphere { 0, 1 }");
    ASSERT_TRUE(run.model) << run.problems();
    EXPECT_EQ(std::get<UnsupportedShape>(run.model->objects[0]->shape).kind, "difference");
}

struct Bad {
    const char *name, *text, *code, *message;
};

class SdlBad : public testing::TestWithParam<Bad> {};

TEST_P(SdlBad, IsToldWithItsPlace) {
    Limits limits;
    limits.tokens = 200'000; // a runaway loop ends soon
    const SdlRun run(GetParam().text, "scene.pov", limits);
    EXPECT_FALSE(run.model);
    EXPECT_NE(run.problems().find(GetParam().code), std::string::npos) << run.problems();
    EXPECT_NE(run.problems().find(GetParam().message), std::string::npos) << run.problems();
    EXPECT_NE(run.problems().find("scene.pov:"), std::string::npos) << run.problems();
}

INSTANTIATE_TEST_SUITE_P(
    All, SdlBad,
    testing::Values(Bad{"String", "#declare A = \"abc", "sdl.unterminated-string", "no closing quote"},
                    Bad{"Comment", "sphere { /* 0, 1 }", "sdl.unterminated-comment", "no end"},
                    Bad{"Include", "#include \"not_there.inc\"", "sdl.include-missing", "not_there.inc"},
                    Bad{"Recursion", "#macro M() M() #end M()", "sdl.recursion", "in macro M, called here"},
                    Bad{"Argument", "#macro M(A) M(M(A)) #end M(1)", "sdl.", "scene.pov"},
                    Bad{"Loop", "#while (1) #end", "sdl.runs-too-long", "200000"},
                    Bad{"NoEnd", "#if (1) sphere { 0, 1 }", "sdl.no-end", "no #end"},
                    Bad{"Nesting", "#macro M(N) (M(N)) #end #declare A = M(1);", "sdl.", "scene.pov"},
                    Bad{"Type", "sphere { \"a\", 1 }", "sdl.unexpected",
                        "expected a number or a vector, found a string"},
                    Bad{"Undeclared", "sphere { Nowhere, 1 }", "sdl.undeclared", "'Nowhere' is not declared"},
                    Bad{"Index", "#declare A = array[2]; #declare A[2] = 1;", "sdl.index",
                        "index 2 of 'A', which has 2 elements"},
                    Bad{"Array", "#declare A = array[1e9];", "sdl.array", "1000000000"},
                    Bad{"Arguments", "#macro M(A, B) #end M(1)", "sdl.arguments", "takes 2 arguments, not 1"},
                    Bad{"Reserved", "#declare sphere = 1;", "sdl.reserved", "'sphere'"},
                    Bad{"Brace", "union { sphere { 0, 1 }", "sdl.unexpected", "found the end of the file"},
                    Bad{"Error", "#error concat(\"stop\", \" it\")", "sdl.error-directive", "stop it"},
                    Bad{"Write", "#fopen F \"x\" write", "sdl.file-access", "refused"},
                    Bad{"Directive", "#decalre A = 1;", "sdl.directive", "#decalre"},
                    Bad{"Mesh", "mesh2 { vertex_vectors { 1, x } face_indices { 1, <0, 0, 1> } }", "sdl.mesh",
                        "index 1 of 1 vertices"},
                    Bad{"Character", "sphere { 0, 1 } \\", "sdl.character", "'\\'"}),
    [](const auto& tested) { return tested.param.name; });

TEST(SdlBad, ManyOpenParenthesesAreRefused) {
    const SdlRun run("#declare A = " + std::string(100'000, '(') + "1;");
    EXPECT_NE(run.problems().find("sdl.too-deep"), std::string::npos);
    const SdlRun braces([] {
        std::string text;
        for (int i = 0; i < 100'000; ++i) text += "union { ";
        return text;
    }());
    EXPECT_NE(braces.problems().find("sdl.too-deep"), std::string::npos);
}

TEST(SdlBad, AFileThatIncludesItselfIsRefused) {
    const auto folder = std::filesystem::temp_directory_path() / "yarte_sdl_self";
    std::filesystem::create_directories(folder);
    writeFile(folder / "self.inc", "#include \"self.inc\"");
    const SdlRun run("#include \"self.inc\"", folder / "scene.pov");
    EXPECT_NE(run.problems().find("sdl.recursion"), std::string::npos);
    EXPECT_NE(run.problems().find("in self.inc, included here"), std::string::npos);
    std::filesystem::remove_all(folder);
}

TEST(SdlBad, DivisionByZeroIsInfiniteAndWarns) {
    const SdlRun run("#debug str(1/0, 0, 2)");
    EXPECT_EQ(run.printed, "inf");
    EXPECT_NE(run.problems().find("sdl.division-by-zero"), std::string::npos);
}

} // namespace
} // namespace yarte::convert::povray::sdl::test
