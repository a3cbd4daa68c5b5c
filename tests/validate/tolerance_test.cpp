// Tolerances: reading them, their mistakes, and judging by them.
#include "validate/tolerance_json.h"
#include "validate/verdict.h"

#include "yarte/base/file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace yarte::validate::test {
namespace {

namespace fs = std::filesystem;

/// "place code" of every problem of a file with that text.
std::vector<std::string> problemsOf(const std::string& text) {
    try {
        parseTolerance(text, "/scenes/tolerance.json");
    } catch (const ToleranceError& error) {
        std::vector<std::string> list;
        for (const ToleranceProblem& p : error.problems())
            list.push_back(fmt::format("{} {}", p.place, p.code));
        return list;
    }
    return {};
}

TEST(ToleranceTest, DefaultIsStrict) {
    const Tolerance tolerance = toleranceFor("/no/such/folder/scene.yarte", "");
    EXPECT_EQ(tolerance.condition.kind, Condition::Kind::maxAbs);
    EXPECT_EQ(tolerance.condition.limit, 4.0 / 65535);
    EXPECT_EQ(tolerance.threshold, 4.0 / 65535);
    EXPECT_EQ(tolerance.source, "");
}

TEST(ToleranceTest, ReadsEverything) {
    const Tolerance t = parseTolerance(R"({
        "$schema": "tolerance.schema.json",
        "all": [
            {"max_abs": "8/65535", "except": {"silhouette": 2, "rectangles": [[1, 2, 3, 4]]}, "reason": "r1"},
            {"any": [{"rmse": 0.001}, {"flip_mean": 0.01}], "reason": "r2", "only": {"images": ["mask.png"]}},
            {"pixels_over": {"threshold": 0.5, "count": 3}, "reason": "r3"},
            {"pixels_over": {"threshold": 0.25, "fraction": 0.01}, "reason": "r4"}
        ]})",
                                       "/scenes/x/tolerance.json");
    ASSERT_EQ(t.condition.kind, Condition::Kind::all);
    ASSERT_EQ(t.condition.parts.size(), 4u);
    const Condition &first = t.condition.parts[0], &any = t.condition.parts[1];
    EXPECT_EQ(first.limit, 8.0 / 65535);
    EXPECT_EQ(first.except.silhouette, 2);
    EXPECT_EQ(first.except.rectangles, (std::vector<PixelBox>{{1, 2, 3, 4}}));
    EXPECT_EQ(first.reason, "r1");
    EXPECT_EQ(first.pointer, "/all/0");
    EXPECT_EQ(any.kind, Condition::Kind::any);
    EXPECT_EQ(any.only.images, (std::vector<fs::path>{"/scenes/x/mask.png"}));
    EXPECT_EQ(any.parts[1].kind, Condition::Kind::flipMean);
    EXPECT_EQ(any.parts[1].pointer, "/all/1/any/1");
    EXPECT_EQ(t.condition.parts[2].kind, Condition::Kind::pixelCount);
    EXPECT_EQ(t.condition.parts[3].kind, Condition::Kind::pixelFraction);
    EXPECT_EQ(t.condition.parts[3].threshold, 0.25);
    EXPECT_EQ(t.threshold, 8.0 / 65535) << "the smallest of a single pixel's thresholds";
    EXPECT_EQ(t.source, "/scenes/x/tolerance.json");
}

TEST(ToleranceTest, EveryMistakeHasItsPlaceAndCode) {
    using List = std::vector<std::string>;
    EXPECT_EQ(problemsOf("{\n  \"rmse\" 1}"), List{"2:10 tolerance.not-json"});
    EXPECT_EQ(problemsOf(R"({"rmse": 1e999, "reason": "r"})"), List{" tolerance.number-too-large"});
    EXPECT_EQ(problemsOf(R"({"rmse": "1e300/1e-300", "reason": "r"})"),
              List{"/rmse tolerance.limit-not-number"});
    EXPECT_EQ(problemsOf("[]"), List{" tolerance.condition-invalid"});
    EXPECT_EQ(problemsOf("{}"), List{" tolerance.condition-invalid"});
    EXPECT_EQ(problemsOf(R"({"rmse": 1, "max_abs": 1})"), List{" tolerance.condition-invalid"});
    EXPECT_EQ(problemsOf(R"({"rmse": "a", "reason": "r"})"), List{"/rmse tolerance.limit-not-number"});
    EXPECT_EQ(problemsOf(R"({"rmse": "1/0", "reason": "r"})"), List{"/rmse tolerance.limit-not-number"});
    EXPECT_EQ(problemsOf(R"({"rmse": -1, "reason": "r"})"), List{"/rmse tolerance.limit-negative"});
    EXPECT_EQ(problemsOf(R"({"all": []})"), List{"/all tolerance.not-a-list"});
    EXPECT_EQ(problemsOf(R"({"all": [3]})"), List{"/all/0 tolerance.condition-invalid"});
    EXPECT_EQ(problemsOf(R"({"rmse": 1, "reason": ""})"), List{"/reason tolerance.reason-invalid"});
    EXPECT_EQ(problemsOf(R"({"rsme": 1})"),
              (List{" tolerance.condition-invalid", "/rsme tolerance.unknown-key"}));
    EXPECT_EQ(problemsOf(R"({"pixels_over": {"threshold": 1}, "reason": "r"})"),
              List{"/pixels_over tolerance.pixels-over-invalid"});
    EXPECT_EQ(problemsOf(R"({"pixels_over": {"threshold": 1, "fraction": 2}, "reason": "r"})"),
              List{"/pixels_over/fraction tolerance.fraction-above-1"});
    EXPECT_EQ(problemsOf(R"({"pixels_over": {"threshold": 1, "count": 2, "kind": 1}, "reason": "r"})"),
              List{"/pixels_over/kind tolerance.unknown-key"});
    const auto except = [](const std::string& set) {
        return problemsOf(fmt::format(R"({{"max_abs": 1, "reason": "r", "except": {}}})", set));
    };
    EXPECT_EQ(except("{}"), List{"/except tolerance.set-invalid"});
    EXPECT_EQ(except(R"({"edges": 1})"), List{"/except/edges tolerance.unknown-key"});
    EXPECT_EQ(except(R"({"silhouette": 0})"), List{"/except/silhouette tolerance.silhouette-invalid"});
    EXPECT_EQ(except(R"({"rectangles": [[0, 0, 0, 1]]})"),
              List{"/except/rectangles/0 tolerance.rectangle-invalid"});
    EXPECT_EQ(except(R"({"rectangles": [[0, 0, 1.5, 1]]})"),
              List{"/except/rectangles/0 tolerance.rectangle-invalid"});
    EXPECT_EQ(except(R"({"images": [1]})"), List{"/except/images/0 tolerance.image-invalid"});
    EXPECT_EQ(except(R"({"images": ["../secret.png"]})"), List{"/except/images/0 tolerance.image-outside"});
    EXPECT_EQ(problemsOf(R"({"all": [{"rmse": -1, "reason": "r"}, {"max_abs": []}]})"),
              (List{"/all/0/rmse tolerance.limit-negative", "/all/1/max_abs tolerance.limit-not-number"}))
        << "all mistakes in one run";
}

TEST(ToleranceTest, GroupsAreNotDeep) {
    const auto nested = [](int levels) {
        std::string text = "{\"max_abs\": \"4/65535\"}", before;
        for (int i = 0; i < levels; ++i) before += "{\"all\": [", text += "]}";
        return before + text;
    };
    EXPECT_THAT(problemsOf(nested(50)), testing::IsEmpty());
    EXPECT_THAT(problemsOf(nested(51)), testing::ElementsAre(testing::EndsWith(" tolerance.too-deep")));
    EXPECT_THAT(problemsOf(nested(100'000)), testing::ElementsAre(testing::EndsWith(" tolerance.too-deep")))
        << "the reader's stack";
}

// The table that check_tolerances.py runs through the published schema.
TEST(ToleranceTest, ReadsAndRefusesWhatTheSchemaSays) {
    const auto table =
        nlohmann::json::parse(readFile(YARTE_SOURCE_DIR "/tests/validate/data/tolerances.json"));
    ASSERT_GT(table.size(), 50u);
    for (const auto& entry : table) {
        const std::string text = entry.at("file").dump();
        EXPECT_EQ(problemsOf(text).empty(), entry.at("good").get<bool>())
            << text << "\n"
            << fmt::format("{}", fmt::join(problemsOf(text), "\n"));
    }
}

TEST(ToleranceTest, OnlyTheDefaultNeedsNoReason) {
    EXPECT_TRUE(problemsOf(R"({"max_abs": "4/65535"})").empty());
    EXPECT_TRUE(problemsOf(R"({"pixels_over": {"threshold": "4/65535", "count": 0}})").empty());
    EXPECT_TRUE(problemsOf(R"({"any": [{"rmse": 1}, {"flip_mean": 1}], "reason": "of the group"})").empty());
    const std::vector<std::string> missing = {" tolerance.reason-missing"};
    EXPECT_EQ(problemsOf(R"({"max_abs": "5/65535"})"), missing);
    EXPECT_EQ(problemsOf(R"({"max_abs": "3/65535"})"), missing) << "a stricter one, too";
    EXPECT_EQ(problemsOf(R"({"max_abs": "4/65535", "except": {"silhouette": 1}})"), missing);
    EXPECT_EQ(problemsOf(R"({"all": [{"max_abs": "4/65535"}], "only": {"silhouette": 1}})"),
              std::vector<std::string>{"/all/0 tolerance.reason-missing"});
}

TEST(ToleranceTest, ProblemsReadLikeACompilers) {
    try {
        parseTolerance(R"({"all": [{"rmse": -1, "reason": "r"}]})", "t.json");
        FAIL();
    } catch (const ToleranceError& error) {
        EXPECT_STREQ(error.what(),
                     "t.json#/all/0/rmse: error: must not be negative, got -1 [tolerance.limit-negative]");
    }
}

/// Black pictures of 10 x 10 pixels that differ by 0.1 in (2, 3), by 0.3 in (7, 7).
class JudgeTest : public testing::Test {
protected:
    JudgeTest() {
        a_.pixels[32] = {0.1, 0, 0};
        b_.pixels[77] = {0, 0.3, 0};
        flip_.values[32] = 0.5f, flip_.values[77] = 0.25f;
    }

    Judgement judged(const std::string& json, const Aov* aov = nullptr) {
        return judge(parseTolerance(json, folder_ / "tolerance.json"), {a_.view(), b_.view(), flip_, aov});
    }
    bool holds(const std::string& json) { return judged(json).holds; }
    /// With a reason.
    bool leafHolds(const std::string& leaf) { return holds(fmt::format(R"({{{}, "reason": "r"}})", leaf)); }

    Picture a_{10, 10, std::vector<Colour>(100)}, b_ = a_;
    FlipMap flip_{10, 10, std::vector<float>(100)};
    fs::path folder_ = fs::path(YARTE_TEST_OUTPUT) / "tolerance";
};

TEST_F(JudgeTest, EachMetricHoldsUpToItsLimit) {
    EXPECT_TRUE(leafHolds(R"("max_abs": 0.3)"));
    EXPECT_FALSE(leafHolds(R"("max_abs": 0.2999)"));
    const double rmse = std::sqrt((0.01 + 0.09) / 300);
    EXPECT_TRUE(leafHolds(fmt::format(R"("rmse": {})", rmse * 1.000001)));
    EXPECT_FALSE(leafHolds(fmt::format(R"("rmse": {})", rmse * 0.999999)));
    EXPECT_TRUE(leafHolds(R"("flip_mean": 0.0075)"));
    EXPECT_FALSE(leafHolds(R"("flip_mean": 0.0074)"));
    EXPECT_TRUE(leafHolds(R"("pixels_over": {"threshold": 0.05, "count": 2})"));
    EXPECT_FALSE(leafHolds(R"("pixels_over": {"threshold": 0.05, "count": 1})"));
    EXPECT_TRUE(leafHolds(R"("pixels_over": {"threshold": 0.2, "count": 1})"));
    EXPECT_TRUE(leafHolds(R"("pixels_over": {"threshold": 0.05, "fraction": 0.02})"));
    EXPECT_FALSE(leafHolds(R"("pixels_over": {"threshold": 0.05, "fraction": 0.0199})"));
}

TEST_F(JudgeTest, GroupsCombine) {
    const std::string yes = R"({"rmse": 1})", no = R"({"rmse": 0})";
    const auto group = [&](const char* kind, const std::string& x, const std::string& y) {
        return leafHolds(fmt::format(R"("{}": [{}, {}])", kind, x, y));
    };
    EXPECT_TRUE(group("all", yes, yes));
    EXPECT_FALSE(group("all", yes, no));
    EXPECT_TRUE(group("any", no, yes));
    EXPECT_FALSE(group("any", no, no));
    EXPECT_TRUE(leafHolds(fmt::format(R"("all": [{}, {{"any": [{}, {}]}}])", yes, no, yes)));
}

TEST_F(JudgeTest, RectanglesOnlyAndExcept) {
    EXPECT_TRUE(leafHolds(R"("max_abs": 0.1, "except": {"rectangles": [[7, 7, 8, 8]]})"));
    EXPECT_FALSE(leafHolds(R"("max_abs": 0.1, "except": {"rectangles": [[7, 6, 8, 7]]})"));
    EXPECT_TRUE(leafHolds(R"("max_abs": 0.1, "only": {"rectangles": [[0, 0, 7, 99]]})"));
    EXPECT_TRUE(leafHolds(R"("max_abs": 0, "only": {"rectangles": [[99, 99, 100, 100]]})")) << "outside";
    EXPECT_FALSE(leafHolds(R"("pixels_over": {"threshold": 0.05, "fraction": 0.02},
                              "only": {"rectangles": [[2, 3, 4, 4]]})"))
        << "a part of the judged pixels: 1 of 2";
    EXPECT_TRUE(leafHolds(R"("all": [{"max_abs": 0.1}], "except": {"rectangles": [[7, 7, 8, 8]]})"))
        << "a group's mask is its parts'";
}

TEST_F(JudgeTest, MaskImages) {
    fs::create_directories(folder_);
    std::string pgm = "P5 10 10 255\n" + std::string(100, '\0');
    pgm[pgm.size() - 100 + 77] = 1;
    writeFile(folder_ / "mask.pgm", pgm);
    EXPECT_TRUE(leafHolds(R"("max_abs": 0.1, "except": {"images": ["mask.pgm"]})"));
    EXPECT_FALSE(leafHolds(R"("max_abs": 0.1, "only": {"images": ["mask.pgm"]})"));
    writeFile(folder_ / "small.pgm", "P5 1 1 255\nx");
    EXPECT_THROW(leafHolds(R"("max_abs": 1, "only": {"images": ["small.pgm"]})"), JudgementError);
    EXPECT_THROW(leafHolds(R"("max_abs": 1, "only": {"images": ["missing.pgm"]})"), JudgementError);
}

TEST_F(JudgeTest, SilhouetteAllowance) {
    Aov aov; // a body in the columns from 7 on
    aov.width = aov.height = 10;
    for (int i = 0; i < 100; ++i) aov.body.push_back(i % 10 < 7 ? -1 : 0);
    aov.reflectedBody = aov.transmittedBody = std::vector<int>(100, -1);
    const auto holdsNear = [&](int distance) {
        return judged(fmt::format(R"({{"max_abs": 0, "except": {{"silhouette": {}}}, "reason": "r"}})",
                                  distance),
                      &aov)
            .holds;
    };
    b_.pixels[77] = {};          // the column 7 is along the edge,
    a_.pixels[32] = {};          // and
    b_.pixels[38] = {0, 0.2, 0}; // 8 is one pixel from it
    EXPECT_FALSE(holdsNear(1));
    EXPECT_TRUE(holdsNear(2));
    b_.pixels[38] = {}, b_.pixels[36] = {0.2, 0, 0};
    EXPECT_TRUE(holdsNear(1)) << "both sides of the edge";
    EXPECT_THROW(judged(R"({"max_abs": 0, "except": {"silhouette": 1}, "reason": "r"})"), JudgementError)
        << "without knowledge of the scene";
}

TEST_F(JudgeTest, SaysWhatFailedAndByHowMuch) {
    const Judgement j = judged(R"({"all": [{"max_abs": "4/65535", "except": {"rectangles": [[7, 7, 8, 8]]},
                                            "reason": "a lamp"},
                                           {"rmse": 1, "reason": "easy"},
                                           {"pixels_over": {"threshold": 0.01, "count": 0}, "reason": "none"}]})");
    EXPECT_FALSE(j.holds);
    EXPECT_EQ(j.message,
              "max_abs <= 4/65535 except [7, 7, 8, 8] does not hold: 0.1, 1.64e+03 times the limit "
              "(/all/0)\npixels over 0.01 <= 0 does not hold: 2 (/all/2)");
    ASSERT_EQ(j.conditions.size(), 4u);
    EXPECT_TRUE(j.conditions[0].isGroup);
    EXPECT_EQ(j.conditions[1].depth, 1);
    EXPECT_DOUBLE_EQ(j.conditions[1].measured, 0.1);
    EXPECT_EQ(j.conditions[1].reason, "a lamp");
    EXPECT_TRUE(j.conditions[2].holds);
    EXPECT_EQ(j.conditions[3].text, "pixels over 0.01 <= 0");
}

TEST_F(JudgeTest, FoundBesideTheScene) {
    const fs::path folder = folder_ / "beside";
    fs::create_directories(folder);
    writeFile(folder / "tolerance.json", R"({"rmse": 0.5, "reason": "r"})");
    EXPECT_EQ(toleranceFor(folder / "scene.yarte", "").condition.limit, 0.5);
    writeFile(folder / "other.json", R"({"rmse": 0.25, "reason": "r"})");
    EXPECT_EQ(toleranceFor(folder / "scene.yarte", folder / "other.json").condition.limit, 0.25)
        << "the one that is named wins";
    EXPECT_THROW(toleranceFor(folder / "scene.yarte", folder / "missing.json"), FileError);
}

} // namespace
} // namespace yarte::validate::test
