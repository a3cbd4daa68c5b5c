// The parts of `yarte-validate speed`: numbers against those computed by hand.
#include "validate/speed/box_filter.h"
#include "validate/speed/log_plot.h"
#include "validate/speed/measure_pixels.h"
#include "validate/speed/measure_rays.h"
#include "validate/speed/measure_tessellation.h"
#include "validate/speed/povray_rays.h"
#include "validate/speed/speed_html.h"
#include "validate/speed/speed_json.h"
#include "validate/speed/speed_plots.h"
#include "validate/speed/timing.h"

#include "tests/validate/support.h"
#include "validate/compare.h"
#include "validate/program.h"
#include "validate/report_json.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>

namespace yarte::validate {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

TEST(BoxFilter, PixelsAreMeansOfSquares) {
    Picture fine{4, 2, {}};
    for (const double v : {1., 2., 10., 20., 3., 6., 30., 60.}) fine.pixels.push_back({v, 0, -v});
    const Picture coarse = boxFiltered(fine, 2);
    EXPECT_EQ(coarse.width, 2);
    EXPECT_EQ(coarse.height, 1);
    EXPECT_THAT(coarse.pixels, ElementsAre(Colour{3, 0, -3}, Colour{30, 0, -30}));
    EXPECT_EQ(boxFiltered(fine, 1).pixels, fine.pixels);
}

TEST(PictureError, IsThatOfAllChannels) {
    const Picture reference = test::constantPicture(2, 1, {0.5, 0.5, 0.5});
    Picture picture = reference;
    picture.pixels[1] = {0.5, 0.75, 0.25};
    const PictureError error = pictureError(picture, reference);
    EXPECT_DOUBLE_EQ(error.rmse, std::sqrt((0.0625 + 0.0625) / 6));
    EXPECT_DOUBLE_EQ(error.maxAbs, 0.25);
    EXPECT_EQ(pictureError(reference, reference).rmse, 0);
    EXPECT_THROW(pictureError(picture, test::constantPicture(1, 2, {})), CaseError);
}

TEST(Timing, MedianLeastAndMost) {
    Timing timing;
    EXPECT_FALSE(timing.seconds().median);
    timing.add(3), timing.add(std::nullopt), timing.add(1), timing.add(10);
    EXPECT_EQ(timing.seconds().median, 3);
    EXPECT_EQ(timing.seconds().least, 1);
    EXPECT_EQ(timing.seconds().most, 10);
    timing.add(5);
    EXPECT_EQ(timing.seconds().median, 4);
}

TrueHit truth(int body, const Real& distance) { return {body, distance, Vec3{0, 0, 1}}; }

TEST(RayErrors, AreOfRaysThatMeetTheSameBody) {
    const Vec3 up{0, 0, 1};
    const RayErrors errors = rayErrors("some", {
                                                   {truth(1, 4), {1, 4.5, up}},
                                                   {truth(1, 2), {1, 2, {0, 0, -2}}}, // its other side
                                                   {truth(2, 1), {2, 1, {1, 0, 0}}},
                                                   {truth(2, 1), {1, 1, up}},
                                                   {truth(2, 1), {}},
                                                   {std::nullopt, {1, 1, up}},
                                                   {std::nullopt, {}},
                                               });
    EXPECT_EQ(errors.name, "some");
    EXPECT_EQ(errors.compared, 3u);
    EXPECT_EQ(errors.otherwise, 3u);
    EXPECT_DOUBLE_EQ(errors.distance.max, 0.125);
    EXPECT_DOUBLE_EQ(errors.distance.rms, 0.125 / std::sqrt(3));
    EXPECT_EQ(errors.distance.median, 0);
    EXPECT_DOUBLE_EQ(errors.normal.max, std::sqrt(2));
    EXPECT_EQ(errors.normal.median, 0);
}

TEST(RayErrors, SeeWhatDoubleCannot) {
    const Real distance = Real(1) / 3;
    const RayErrors errors = rayErrors("double", {{truth(0, distance), {0, 1.0 / 3, {0, 0, 1}}}});
    EXPECT_GT(errors.distance.max, 1e-18);
    EXPECT_LT(errors.distance.max, 1.2e-16);
}

TEST(Hits, AreRead) {
    const std::string head = "x,y,body,distance,normal_x,normal_y,normal_z\n";
    const auto answers = hitsIn(head + "0,0,-1,0,0,0,0\n1,0,3,1.5e2,0,-0.6,0.8\n");
    ASSERT_EQ(answers.size(), 2u);
    EXPECT_EQ(answers[0].body, -1);
    EXPECT_EQ(answers[1].body, 3);
    EXPECT_EQ(answers[1].distance, 150);
    EXPECT_EQ(answers[1].normal, (Vec3{0, -0.6, 0.8}));
    for (const std::string& bad :
         {std::string("x,y\n"), head + "1,2,3\n", head + "0,0,1,a,0,0,0\n", head + "0,0,1,0,0,0,0,0\n"})
        EXPECT_THROW(hitsIn(bad), CaseError) << bad;
}

TEST(Hits, HaveASizeOfThePicturesShape) {
    EXPECT_EQ(sizeForRays(640, 480, 1200), (Resolution{40, 30}));
    EXPECT_EQ(sizeForRays(16, 12, 4096), (Resolution{16, 12})) << "no more rays than pixels";
    EXPECT_EQ(sizeForRays(1000, 1, 1), (Resolution{31, 1}));
}

TEST(PovrayRays, EachBodyGetsANameAndNothingElse) {
    const std::string sdl =
        "// how it is done\n#macro M() sphere { } #end\n\n// light, line 2\nlight_source { }\n\n"
        "// sphere, line 5\nsphere {\n    x\n}\n\n// box, line 9\n#declare Axes = 1;\nbox {\n}\n";
    const std::string text = askingScene(sdl, 2, {{{1, 0, 0.5}, {0, 0, -1}, 1}}, "answers.csv");
    EXPECT_THAT(text, HasSubstr("// sphere, line 5\n#declare Body_0 = sphere {\n"));
    EXPECT_THAT(text, HasSubstr("#declare Axes = 1;\n#declare Body_1 = box {\n"));
    EXPECT_THAT(text, HasSubstr("// light, line 2\nlight_source {"));
    EXPECT_THAT(text, HasSubstr("#fopen Answers \"answers.csv\" write"));
    EXPECT_THAT(text, HasSubstr("Ask(Body_1, <1, 0, 0.5>, <0, 0, -1>)\n"));
    EXPECT_THAT(text, Not(HasSubstr("Body_2")));
    EXPECT_THROW(askingScene(sdl, 3, {}, "a"), CaseError);
}

TEST(PovrayRays, AnswersAreInTheOrderOfTheQuestions) {
    const std::vector<RayQuestion> questions{{{}, {}, 4}, {{}, {}, 7}};
    const auto answers = answersIn("120.0,-nan,-nan,-nan\n2.5,0.0,0.6,-0.8\n", questions);
    ASSERT_EQ(answers.size(), 2u);
    EXPECT_EQ(answers[0].body, -1);
    EXPECT_EQ(answers[1].body, 7);
    EXPECT_EQ(answers[1].distance, 2.5);
    EXPECT_EQ(answers[1].normal, (Vec3{0, 0.6, -0.8}));
    EXPECT_THROW(answersIn("1,0,0,1\n", questions), CaseError) << "one is missing";
}

TEST(PovrayRays, WhereNothingIsMetTheNormalIsZero) {
    const auto answers = answersIn("120.0,0.0,0.0,0.0\n", {{{}, {}, 4}});
    ASSERT_EQ(answers.size(), 1u);
    EXPECT_EQ(answers[0].body, -1);
}

TEST(Tessellation, TheLedgerTellsTheNumbers) {
    const LedgerTotals totals = tessellationInLedger(R"json({"rows": [
        {"where": "body 1 (sphere)", "property": "surface", "detail": "128 triangles", "bound": 0.25},
        {"where": "body 2 (disc)", "property": "surface", "detail": "20 triangles", "bound": 0.5},
        {"where": "scene", "property": "everything", "detail": "canonical", "bound": null}]})json");
    EXPECT_EQ(totals.triangles, 148u);
    EXPECT_EQ(totals.deviation, 0.5);
    EXPECT_EQ(tessellationInLedger("no json").triangles, 0u);
}

TEST(Tessellation, TheLargestRadiusIsThatOfCurvedShapes) {
    Scene scene;
    const auto add = [&](Shape shape) { scene.bodies.push_back({std::move(shape), {}, {}, {}, {}}); };
    add(Box{{}, {9, 9, 9}});
    EXPECT_EQ(largestRadius(scene), 0);
    add(Sphere{{}, 2}), add(Frustum{{}, 1, 3, 1}), add(Disc{{}, 1.5});
    EXPECT_EQ(largestRadius(scene), 3);
}

int count(const std::string& text, const std::string& part) {
    int n = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
    return n;
}

const LogPlot decades{"A & B", "time", "error", {{"one", {{0.01, 1, "a", ""}, {1, 0.01, "b", "<tip>"}}}}};

TEST(LogPlot, EqualFactorsAreEqualDistances) {
    LogPlot plot = decades;
    plot.curves[0].points.insert(plot.curves[0].points.begin() + 1, {0.1, 0.1, "", ""});
    const std::string text = svg(plot);
    const std::string start = "<polyline points=\"";
    const std::size_t at = text.find(start);
    ASSERT_NE(at, std::string::npos);
    double x[3], y[3];
    ASSERT_EQ(std::sscanf(text.c_str() + at + start.size(), "%lf,%lf %lf,%lf %lf,%lf", &x[0], &y[0], &x[1],
                          &y[1], &x[2], &y[2]),
              6);
    EXPECT_NEAR(x[1] - x[0], x[2] - x[1], 0.11);
    EXPECT_NEAR(y[1] - y[0], y[2] - y[1], 0.11);
    EXPECT_GT(x[1] - x[0], 100) << "to the right";
    EXPECT_GT(y[1] - y[0], 50) << "less is further down";
    for (const char* tick : {">0.01<", ">0.1<", ">1<"}) EXPECT_EQ(count(text, tick), 2) << tick;
}

TEST(LogPlot, WhatHasNoLogarithmIsLeftOut) {
    LogPlot plot = decades;
    plot.curves[0].points.push_back({1, 0, "exact", ""});
    plot.curves[0].points.push_back({std::nan(""), 1, "unknown", ""});
    EXPECT_EQ(count(svg(plot), "<title>"), 2);
    EXPECT_THAT(svg(plot), Not(HasSubstr("exact")));
    plot.curves[0].points = {{1, 0, "", ""}};
    EXPECT_EQ(svg(plot), "");
    EXPECT_EQ(svgFile(plot), "");
}

TEST(LogPlot, LabelsDoNotCoverOneAnother) {
    LogPlot plot = decades;
    plot.curves[0].points = {{1, 1, "first", ""}, {1, 1.0001, "second", ""}, {100, 0.001, "third", ""}};
    const std::string text = svg(plot);
    EXPECT_THAT(text, HasSubstr("first"));
    EXPECT_THAT(text, Not(HasSubstr("second")));
    EXPECT_THAT(text, HasSubstr("third"));
    EXPECT_EQ(count(text, "<circle"), 4) << "each point, and the legend";
}

TEST(LogPlot, NamesAreText) {
    EXPECT_THAT(svg(decades), HasSubstr(">A &amp; B<"));
    EXPECT_THAT(svg(decades), HasSubstr("<title>&lt;tip&gt;</title>"));
}

/// With everything that a case can have.
SpeedReport sampleSpeed() {
    const Seconds time{0.25, 0.2, 0.5};
    SpeedCase full;
    full.name = "paper";
    full.source = "scenes/<paper> & co.yarte";
    full.note = "POV-Ray is left out";
    full.width = 64, full.height = 48, full.referenceSamples = 16, full.exposure = 0.5;
    for (const char* name : {"YARTE double", "YARTE fast"}) {
        SamplesCurve curve{name, {}};
        for (const int n : {1, 2})
            curve.points.push_back({n, {0.1 * n * n, 0.1, 0.5}, time, {0.1 / n, 0.5 / n}, std::nullopt});
        full.curves.push_back(curve);
    }
    for (SamplesPoint& point : full.curves[1].points) point.fromDouble = PictureError{1e-6, 1e-5};
    full.tessellation = {"", 2, time, time, time, {{0.2, 0.1, 128, time, time, time, time, {0.01, 0.5}}}};
    const Spread spread{1e-17, 1e-16, 1e-15};
    full.rays = {"", 64, 48, 3000, {{"YARTE double", 2990, 10, spread, spread}}};
    full.commands = {{"yarte 'a<b' -o yarte.pfm", 0.25, "exit code 0"}};
    SpeedCase broken;
    broken.name = "broken";
    broken.message = "yarte: exit code 1\nbad.yarte:1:1: error: <no> & \"quotes\"";
    return {"0.1.0", 3, 1, {full, broken}};
}

TEST(SpeedReport, JsonFitsItsSchema) {
    const auto python = findProgram("python3", {"/usr/bin", "/usr/local/bin"});
    if (!python) GTEST_SKIP() << "skipped: no python3";
    const auto folder = test::scratchFolder();
    const std::filesystem::path root = YARTE_SOURCE_DIR;
    const StopSignal stop;
    const auto errorsOf = [&](const std::string& json) {
        writeFile(folder / "speed.json", json);
        return run({{"/bin/sh", "-c", "\"$@\" >&2", "sh", *python, root / "tests/validate/check_schema.py",
                     root / "validate/speed.schema.json", "speed.json"},
                    folder,
                    {},
                    60,
                    0,
                    0},
                   stop)
            .errorText;
    };
    std::string json = speedJson(sampleSpeed());
    EXPECT_EQ(errorsOf(json), "");
    json.replace(json.find("\"rmse\""), 6, "\"rms\"");
    EXPECT_THAT(errorsOf(json), HasSubstr("rmse is missing"));
}

TEST(SpeedReport, HasADiagramForEachLevel) {
    const SpeedReport report = sampleSpeed();
    std::vector<std::string> files;
    for (const NamedPlot& plot : plotsOf(report.cases[0])) files.push_back(plot.file);
    EXPECT_THAT(files, ElementsAre("plots/paper-rays-distance.svg", "plots/paper-rays-normal.svg",
                                   "plots/paper-pixels-rms.svg", "plots/paper-pixels-max.svg",
                                   "plots/paper-triangles-time.svg", "plots/paper-triangles-error.svg"));
    EXPECT_TRUE(plotsOf(report.cases[1]).empty());
    const std::string pixels = svg(plotsOf(report.cases[0])[2].plot);
    for (const char* name : {">YARTE double<", ">YARTE fast<", ">fast against double<"})
        EXPECT_THAT(pixels, HasSubstr(name));
    EXPECT_THAT(pixels, Not(HasSubstr(">POV-Ray<")));
    EXPECT_EQ(count(pixels, "<title>"), 6);
}

TEST(SpeedReport, PageAndDiagramsAreWellFormed) {
    const auto xmllint = findProgram("xmllint", {"/usr/bin", "/usr/local/bin"});
    if (!xmllint) GTEST_SKIP() << "skipped: no xmllint";
    const auto folder = test::scratchFolder();
    const StopSignal stop;
    const auto complaints = [&](const std::string& file, const std::string& text) {
        writeFile(folder / file, text);
        return run({{*xmllint, "--noout", file}, folder, {}, 60, 0, 0}, stop).errorText;
    };
    const SpeedReport report = sampleSpeed();
    for (const NamedPlot& plot : plotsOf(report.cases[0]))
        EXPECT_EQ(complaints("plot.svg", svgFile(plot.plot)), "") << plot.file;
    // Without what HTML writes otherwise than XML: its first lines and the elements that have no end.
    const std::string html = speedHtml(report);
    const std::size_t begin = html.find("<body>"), end = html.find("</html>");
    ASSERT_NE(begin, std::string::npos);
    EXPECT_EQ(complaints("page.xml", html.substr(begin, end - begin)), "");
    EXPECT_THAT(html, HasSubstr("scenes/&lt;paper&gt; &amp; co.yarte"));
    EXPECT_THAT(html, HasSubstr("error: &lt;no&gt;"));
    EXPECT_THAT(html, HasSubstr("POV-Ray is left out"));
    EXPECT_EQ(count(html, "<svg"), 6);
    EXPECT_EQ(count(html, "http"), 6 + 1) << "only the svg elements' names and the policy: no network";
}

} // namespace
} // namespace yarte::validate
