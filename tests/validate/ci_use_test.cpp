// yarte-validate as CI uses it: side by side, with a cache, against a baseline, on GitHub, on foreign
// formats.
#include "tests/support/povray.h"
#include "tests/validate/command_line.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <regex>

namespace yarte::validate {
namespace {

using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;
using namespace test;

class CiUse : public CommandLine {
protected:
    void addScenes(int count) {
        for (int i = 0; i < count; ++i) {
            scenes_.push_back(fmt::format("s{}.yarte", i));
            writeFile(folder_ / scenes_.back(), "");
        }
    }
    /// A POV-Ray that also counts how often it ran.
    void installCounting() {
        install("povray", "#!/bin/sh\necho x >> \"" + (folder_ / "runs").string() + "\"\n" +
                              with(fakePovray, dimSteps).substr(10));
    }
    std::size_t povrayRuns() const {
        const auto file = folder_ / "runs";
        return std::filesystem::exists(file) ? readFile(file).size() / 2 : 0;
    }
    std::string without(const std::string& file, const std::string& times) const {
        return std::regex_replace(readFile(folder_ / "out" / file), std::regex(times), "TIME");
    }
    std::vector<std::string> scenes_;
};

TEST_F(CiUse, APovrayThatGivesUpBeforeItBeginsIsAskedAgain) {
    addScenes(1);
    const auto lateUntil = [&](int run) {
        install("povray",
                fmt::format("#!/bin/sh\necho x >> \"{0}\"\nif [ $(wc -l < \"{0}\") -lt {1} ]; then\n"
                            "echo 'Timed out waiting for worker thread startup' >&2; exit 1; fi\n",
                            (folder_ / "runs").string(), run) +
                    with(fakePovray, dimSteps).substr(10));
    };
    lateUntil(3);
    EXPECT_EQ(validateScenes(scenes_), 0);
    EXPECT_EQ(povrayRuns(), 3U);
    lateUntil(100);
    EXPECT_EQ(validateScenes(scenes_), 3);
    EXPECT_THAT(report(), HasSubstr("Timed out waiting for worker thread startup"));
    EXPECT_EQ(povrayRuns(), 6U);
}

TEST_F(CiUse, CasesSideBySideAreReportedInTheirOrder) {
    addScenes(7);
    // The first is the slowest.
    install("yarte", "#!/bin/sh\ncase $1 in *s0*) /bin/sleep 0.3 ;; *s3*) exit 1 ;; esac\n" +
                         with(fakeYarte, dimPixels).substr(10));
    EXPECT_EQ(validateScenes(scenes_, {"--jobs", "3"}), 3);
    std::size_t at = 0;
    for (const char* line : {"pass   s0", "pass   s1", "pass   s2", "error  s3", "pass   s4", "pass   s5",
                             "pass   s6", "7 cases: 6 pass, 0 fail, 1 error"}) {
        at = output_.find(line, at);
        EXPECT_NE(at, std::string::npos) << line << " is missing or in another place:\n" << output_;
    }
    EXPECT_THAT(report(), HasSubstr("\"jobs\": 3"));
    EXPECT_THAT(readFile(folder_ / "out/summary.md"), HasSubstr("of 3 cases side by side"));
}

TEST_F(CiUse, OneCaseAfterTheOtherIsNotCalledSideBySide) {
    addScenes(2);
    EXPECT_EQ(validateScenes(scenes_, {"--jobs", "1"}), 0);
    EXPECT_THAT(report(), AllOf(HasSubstr("\"jobs\": 1,"), Not(HasSubstr("--processes"))));
    EXPECT_EQ(validateScenes(scenes_, {"--jobs", "0"}), 2);
}

TEST_F(CiUse, AnInterruptStopsAllJobs) {
    addScenes(4);
    install("povray", "#!/bin/sh\nkill -INT $PPID; exec /bin/sleep 600\n");
    EXPECT_EQ(validateScenes(scenes_, {"--jobs", "2"}), 130);
    EXPECT_FALSE(wrote("report.json"));
}

TEST_F(CiUse, TheSameRunGivesTheSameBytesButForTimes) {
    addScenes(3);
    install("yarte", "#!/bin/sh\ncase $1 in *s1*) echo 's1.yarte:1:2: error: no' >&2; exit 1 ;; esac\n" +
                         with(fakeYarte, dimPixels).substr(10));
    const std::string times = R"re("wall_s": [-+.e0-9]+)re";
    const auto texts = [&] {
        EXPECT_EQ(validateScenes(scenes_, {"--jobs", "2"}), 3);
        return std::vector<std::string>{without("report.json", times), without("index.html", times),
                                        without("junit.xml", R"re(time="[.0-9]+")re"),
                                        readFile(folder_ / "out/summary.md"),
                                        readFile(folder_ / "out/images/s0/difference.png")};
    };
    EXPECT_EQ(texts(), texts());
}

TEST_F(CiUse, UnchangedScenesCostPovrayNothing) {
    installCounting();
    const std::vector<std::string> cache = {"--cache", "cache"};
    EXPECT_EQ(validateScenes({"scene.yarte"}, cache), 0);
    EXPECT_EQ(povrayRuns(), 1u);
    EXPECT_THAT(report(), HasSubstr("\"cached\": false"));
    const std::string first = output_;
    EXPECT_EQ(validateScenes({"scene.yarte"}, cache), 0);
    EXPECT_EQ(povrayRuns(), 1u);
    EXPECT_EQ(output_, first) << "the times of the run that made the picture";
    EXPECT_THAT(report(),
                AllOf(HasSubstr("\"cached\": true"), HasSubstr("not run: its picture is in the cache")));
    EXPECT_TRUE(wrote("images/scene/povray.ppm"));
}

TEST_F(CiUse, WhatDecidesThePictureDecidesAboutTheCache) {
    installCounting();
    const std::vector<std::string> cache = {"--cache", "cache"};
    EXPECT_EQ(validateScenes({"scene.yarte"}, cache), 0);
    install("yarte-convert", "#!/bin/sh\necho '// another scene' > \"$2\"\n");
    EXPECT_EQ(validateScenes({"scene.yarte"}, cache), 0);
    EXPECT_EQ(povrayRuns(), 2u) << "another scene";
    install("povray", readFile(folder_ / "povray") + "# another version\n");
    EXPECT_EQ(validateScenes({"scene.yarte"}, cache), 0);
    EXPECT_EQ(povrayRuns(), 3u) << "another POV-Ray";
}

TEST_F(CiUse, DamagedAndFailedPicturesAreNotUsed) {
    installCounting();
    const std::vector<std::string> cache = {"--cache", "cache"};
    EXPECT_EQ(validateScenes({"scene.yarte"}, cache), 0);
    const auto entry = std::filesystem::directory_iterator(folder_ / "cache")->path();
    std::string bytes = readFile(entry);
    bytes.back() = static_cast<char>(bytes.back() ^ 1);
    for (const std::string& damaged : {bytes, bytes.substr(0, 60), std::string("x"), std::string()}) {
        writeFile(entry, damaged);
        const std::size_t before = povrayRuns();
        EXPECT_EQ(validateScenes({"scene.yarte"}, cache), 0);
        EXPECT_EQ(povrayRuns(), before + 1);
    }
    std::filesystem::remove_all(folder_ / "cache");
    install("povray", with(fakePovray, "abc"));
    EXPECT_EQ(validateScenes({"scene.yarte"}, cache), 3);
    EXPECT_FALSE(std::filesystem::exists(folder_ / "cache"));
}

TEST_F(CiUse, ABaselineIsMadeComparedWithAndUpdated) {
    addScenes(2);
    const std::vector<std::string> compare = {"--baseline", "base"},
                                   update = {"--baseline", "base", "--update-baseline"};
    std::filesystem::remove(folder_ / "povray");
    EXPECT_EQ(validateScenes(scenes_, compare), 3);
    EXPECT_THAT(output_, HasSubstr("no reference in base: make it with --update-baseline"));

    EXPECT_EQ(validateScenes(scenes_, update), 0) << output_;
    EXPECT_THAT(output_, HasSubstr("baseline: 2 new (s0, s1), 0 changed, 0 removed, 0 unchanged\n"));
    EXPECT_EQ(validateScenes(scenes_, compare), 0) << output_;
    EXPECT_THAT(output_, HasSubstr("max 0.00/65535"));
    EXPECT_THAT(report(), HasSubstr("\"reference\": \"the baseline base\""));

    // (0, 0.5, 4) where (0, 0.5, 1) was; compared at the exposure 1/4.
    std::string both = with(fakeYarte, dimPixels) +
                       R"sh(case $scene in *s0*) printf 'PF\n2 1\n-1.0\nPIXELS' > "$out" ;; esac)sh";
    install("yarte", "#!/bin/sh\nscene=$1\n" + with(both, brightPixels).substr(10));
    EXPECT_EQ(validateScenes(scenes_, compare), 1) << output_;
    EXPECT_THAT(output_, HasSubstr("fail   s0"));
    EXPECT_EQ(validateScenes(scenes_, update), 0) << output_;
    EXPECT_THAT(output_, HasSubstr("baseline: 0 new, 1 changed (s0: max 0.75), 0 removed, 1 unchanged\n"));
    EXPECT_EQ(validateScenes(scenes_, compare), 0) << output_;

    std::filesystem::remove(folder_ / "s1.yarte");
    EXPECT_EQ(validateScenes({"s0.yarte"}, update), 0) << output_;
    EXPECT_THAT(output_, HasSubstr("baseline: 0 new, 0 changed, 1 removed (s1), 1 unchanged\n"));
    EXPECT_FALSE(std::filesystem::exists(folder_ / "base/s1.exr"));
    EXPECT_EQ(validate({"s0.yarte", "-o", "out", "--update-baseline"}), 2) << "needs --baseline";
}

TEST_F(CiUse, AReferenceThatWasDeletedIsMadeAgain) {
    addScenes(2);
    const std::vector<std::string> update = {"--baseline", "base", "--update-baseline"};
    EXPECT_EQ(validateScenes(scenes_, update), 0) << output_;
    std::filesystem::remove(folder_ / "base/s0.exr");
    EXPECT_EQ(validateScenes(scenes_, {"--baseline", "base"}), 3);
    EXPECT_THAT(output_,
                AllOf(HasSubstr("error  s0"), HasSubstr("no reference in base"), HasSubstr("pass   s1")));
    EXPECT_EQ(validateScenes(scenes_, update), 0) << output_;
    EXPECT_THAT(output_, HasSubstr("baseline: 1 new (s0), 0 changed, 0 removed, 1 unchanged\n"));
    EXPECT_EQ(validateScenes(scenes_, {"--baseline", "base"}), 0) << output_;
}

/// The same with YARTE itself: two spheres on a floor.
class TrueBaseline : public CiUse {
protected:
    static constexpr const char* view = "image_resolution 96 72\ncamera_position 0 3 8\nfocus_point 0 1 0\n"
                                        "camera_apertures 32 25\nlight_source 5 9 6 1\n"
                                        "material .1 .1 .1 .6 .6 .6 0 0 0 1 0 0 0\ndisc 0 0 0 9\n"
                                        "instance_referential 1 0 0 0 0 1 0 -1 0\n";
    static constexpr const char *left = "sphere -1.5 1 0 1\n", *right = "sphere 1.5 1 0 1\n";

    int validateScene(const std::string& text, const std::vector<std::string>& more = {}) {
        writeFile(folder_ / "scene.yarte", text);
        std::vector<std::string> arguments = {
            "scene.yarte", "-o", "out", "--baseline", "base", "--yarte", YARTE_BIN_DIR "/yarte"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return validate(arguments);
    }
};

TEST_F(TrueBaseline, ABodyThatIsGoneIsNamed) {
    ASSERT_EQ(validateScene(std::string(view) + left + right, {"--update-baseline"}), 0)
        << output_ << errors_;
    EXPECT_TRUE(std::filesystem::exists(folder_ / "base/scene.bodies.exr"));
    EXPECT_EQ(validateScene(std::string(view) + left + right), 0) << output_;
    EXPECT_EQ(validateScene(std::string(view) + right), 1);
    EXPECT_THAT(output_, HasSubstr("\n       the sphere at line 9 of the reference's scene is gone\n"));
    EXPECT_EQ(validateScene(std::string(view) + left), 1);
    EXPECT_THAT(output_, HasSubstr("\n       the sphere at line 10 of the reference's scene is gone\n"));
    EXPECT_THAT(report(), HasSubstr("\"subject\": \"sphere at line 10 of the reference's scene\""));
    // What is still there is not called gone.
    EXPECT_EQ(validateScene(std::string(view) + left + "sphere 1.5 1.2 0 1\n"), 1);
    EXPECT_THAT(output_,
                AllOf(HasSubstr("the sphere at line 10 is missing, moved"), Not(HasSubstr("is gone"))));
    EXPECT_EQ(validateScene(std::string(view) + left, {"--update-baseline"}), 0) << output_;
    EXPECT_EQ(validateScene(std::string(view) + left), 0) << output_;

    std::filesystem::remove(folder_ / "scene.yarte");
    writeFile(folder_ / "other.yarte", view);
    EXPECT_EQ(validate({"other.yarte", "-o", "out", "--baseline", "base", "--update-baseline", "--yarte",
                        YARTE_BIN_DIR "/yarte"}),
              0);
    EXPECT_FALSE(std::filesystem::exists(folder_ / "base/scene.bodies.exr"));
}

TEST_F(TrueBaseline, WithoutItsBodiesAReferenceStillCompares) {
    ASSERT_EQ(validateScene(std::string(view) + left + right, {"--update-baseline"}), 0) << output_;
    for (const char* damage : {"no picture", ""}) {
        writeFile(folder_ / "base/scene.bodies.exr", damage);
        EXPECT_EQ(validateScene(std::string(view) + left), 1);
        EXPECT_THAT(output_, AllOf(StartsWith("fail   scene"), Not(HasSubstr("is gone"))));
    }
}

TEST_F(CiUse, ABaselineThatIsNone) {
    std::filesystem::create_directory(folder_ / "base");
    for (const char* text : {"{", "{\"references\": [{\"name\": \"../scene\", \"scene\": \"x\"}]}"}) {
        writeFile(folder_ / "base/baseline.json", text);
        EXPECT_EQ(validateScenes({"scene.yarte"}, {"--baseline", "base"}), 3) << text;
        EXPECT_THAT(errors_, StartsWith("yarte-validate: base/baseline.json: "));
    }
    writeFile(folder_ / "base/baseline.json", "{\"references\": []}");
    writeFile(folder_ / "base/scene.exr", "no picture");
    EXPECT_EQ(validateScenes({"scene.yarte"}, {"--baseline", "base"}), 3);
    EXPECT_THAT(output_, StartsWith("error  scene  2x1  base/scene.exr: "));
}

TEST_F(CiUse, GithubIsToldWhichLineIsWrong) {
    std::filesystem::create_directory(folder_ / "sub");
    writeFile(folder_ / "sub/bad.yarte", "");
    install("yarte", "#!/bin/sh\necho 'bad.yarte:12:9: error: radius, 100% wrong' >&2; exit 1\n");
    const std::vector<std::string> github = {"GITHUB_ACTIONS=true",
                                             fmt::format("GITHUB_WORKSPACE={}", folder_.string())};
    EXPECT_EQ(validateScenes({(folder_ / "sub/bad.yarte").string()}, {}, github), 3);
    EXPECT_THAT(output_,
                EndsWith("::error file=sub/bad.yarte,line=12,title=bad%3A error::yarte: exit code 1%0A"
                         "bad.yarte:12:9: error: radius, 100%25 wrong\n"));
    EXPECT_EQ(validateScenes({"sub/bad.yarte"}), 3);
    EXPECT_THAT(output_, Not(HasSubstr("::error")));
}

TEST_F(CiUse, ForeignScenesAreConvertedFirst) {
    writeFile(folder_ / "model.glb", "");
    install("yarte-convert", "#!/bin/sh\necho \"$(/usr/bin/basename $1) to $2 $3\" > \"$2\"\n");
    EXPECT_EQ(validateScenes({"model.glb"}), 0) << output_;
    EXPECT_EQ(readFile(folder_ / "out/images/model/imported.yarte"), "model.glb to imported.yarte \n");
    EXPECT_EQ(readFile(folder_ / "out/images/model/scene.pov"), "imported.yarte to scene.pov --exposure\n");
}

TEST_F(CiUse, APovraySceneIsRenderedByPovrayAsItIs) {
    writeFile(folder_ / "own.pov", "");
    install("yarte", with(fakeYarte, brightPixels)); // clipped as POV-Ray clips: (0, 0.5, 4) is (0, 0.5, 1)
    EXPECT_EQ(validateScenes({"own.pov"}, {"--cache", "cache"}), 0) << output_;
    EXPECT_THAT(report(), HasSubstr(fmt::format("+I{}", (folder_ / "own.pov").string())));
    EXPECT_FALSE(wrote("images/own/scene.pov"));
    EXPECT_FALSE(std::filesystem::exists(folder_ / "cache")) << "what it includes may change";
    // One that the converter refuses is not run: it may come from a stranger.
    install("yarte-convert", "#!/bin/sh\necho 'no reader for .pov' >&2; exit 2\n");
    install("povray", "#!/bin/sh\necho x > \"" + (folder_ / "ran").string() + "\"\n");
    EXPECT_EQ(validateScenes({"own.pov"}), 3);
    EXPECT_THAT(output_, StartsWith("error  own  yarte-convert: exit code 2\n       no reader for .pov\n"));
    EXPECT_FALSE(std::filesystem::exists(folder_ / "ran"));
}

// Our reader takes vturbulence for 0 and goes another way through these scenes than POV-Ray does.
TEST_F(CiUse, WhatTheConverterDoesNotSeeIsRefusedToPovrayToo) {
    if (!FileRules::areKnown()) GTEST_SKIP() << "skipped: this kernel has no Landlock";
    if (!yarte::test::hasPovray()) GTEST_SKIP() << "skipped: povray not found";
    const auto outside = folder_ / "outside", inside = folder_ / "inside";
    for (const auto& folder : {outside, inside}) std::filesystem::create_directory(folder);
    writeFile(outside / "secret.inc", "#declare Red = 1;\n");
    writeFile(inside / "part.inc", "#declare Red = 1;\n");
    const auto validated = [&](const std::string& statements) {
        writeFile(inside / "scene.pov",
                  "#version 3.7; global_settings { assumed_gamma 1 }\n#declare Red = 1;\n"
                  "#if (vlength(vturbulence(2, 0.5, 6, <1.3, 2.7, 3.1>)) > 0)\n" +
                      statements +
                      "\n#end\ncamera { location -5*z look_at 0 } light_source { <5, 5, -5> 1 }\n"
                      "sphere { 0, 1 pigment { rgb <Red, 0, 0> } finish { ambient 0.1 diffuse 0.7 } }\n");
        return validate({"-o", "out", "--size", "16x12", inside / "scene.pov"},
                        {std::string("PATH=") + std::getenv("PATH")});
    };
    EXPECT_EQ(validated("#include \"part.inc\""), 0) << output_ << errors_;
    EXPECT_EQ(validated(fmt::format("#include \"{}\"", (outside / "secret.inc").string())), 3);
    EXPECT_THAT(output_, HasSubstr("povray: exit code 1")) << errors_;
    EXPECT_EQ(validated("#include \"../outside/secret.inc\""), 3);
    EXPECT_THAT(output_, HasSubstr("povray: exit code 1")) << errors_;
    EXPECT_EQ(validated(fmt::format("#fopen F \"{}\" write #write(F, \"x\") #fclose F",
                                    (outside / "written").string())),
              3);
    EXPECT_THAT(output_, HasSubstr("povray: exit code 1")) << errors_;
    EXPECT_FALSE(std::filesystem::exists(outside / "written"));
}

} // namespace
} // namespace yarte::validate
