// The program `yarte-convert` as users run it: options, files and exit codes.
#include "tests/convert/support.h"
#include "tests/support/program.h"
#include "yarte/version.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include <unistd.h>

namespace yarte::convert::test {
namespace {

using testing::HasSubstr;
using testing::StartsWith;
using yarte::test::ProgramResult;

const std::string shapes = goldenFolder / "shapes.yarte", meshes = goldenFolder / "meshes.yarte";

class YarteConvert : public testing::Test {
protected:
    ProgramResult run(const std::vector<std::string>& arguments) const {
        return yarte::test::run("yarte-convert", arguments, folder_);
    }
    std::vector<std::string> left() const { return yarte::test::namesIn(folder_); }
    std::string bytes(const std::string& name) const { return readFile(folder_ / name); }

    const std::filesystem::path folder_ = yarte::test::emptyTestFolder();
};

TEST_F(YarteConvert, WritesSdlInSilence) {
    const ProgramResult result = run({shapes, "out.pov"});
    EXPECT_EQ(result.exitCode, 0);
    EXPECT_EQ(result.out + result.err, "");
    EXPECT_EQ(bytes("out.pov"), readFile(goldenFolder / "shapes.pov"));
    EXPECT_EQ(left(), std::vector<std::string>{"out.pov"});
}

TEST_F(YarteConvert, TessellatesCurvedShapesAndNothingElse) {
    const std::string material = "material 0.1 0.1 0.1 0.5 0.5 0.5 0 0 0 1 0 0 0\n";
    writeFile(folder_ / "in.yarte", "camera_position 0 0 9\nfocus_point 0 0 0\n" + material +
                                        "sphere 1 2 3 2\nbox 0 0 0 1 1 1\nsphere 5 0 0 2\n"
                                        "truncated_cone 0 1 0 2 8 4\n"
                                        "backface_colour 0 0 0 1 0 0 0 0 0\n"
                                        "instance_referential 1 0 0 0 0 1 0 -1 0\n");
    const ProgramResult result =
        run({"in.yarte", "out.yarte", "--tessellate", "--chord-error", "0.5", "--report", "ledger.json"});
    EXPECT_EQ(result.exitCode, 0) << result.err;
    EXPECT_THAT(result.err, HasSubstr("body 1 (sphere): surface approximated: 128 triangles"));
    const std::string text = bytes("out.yarte");
    // Two spheres share a mesh; the cone's middle is 2 above its base along its axis, which is z here.
    EXPECT_THAT(text, HasSubstr("mesh out.1.pmf 1 1 0 0 0 1 0 0 0 1 1 2 3\n"));
    EXPECT_THAT(text, HasSubstr("mesh out.1.pmf 1 1 0 0 0 1 0 0 0 1 5 0 0\n"));
    EXPECT_THAT(text, HasSubstr("mesh out.2.pmf 1 1 0 0 0 0 1 0 -1 0 0 1 2\n"));
    EXPECT_THAT(text, HasSubstr("box 0 0 0 1 1 1\n"));
    EXPECT_THAT(text, HasSubstr("backface_colour 0 0 0 1 0 0 0 0 0"));
    EXPECT_THAT(text, testing::Not(HasSubstr("instance_referential")));
    const std::string rows = bytes("ledger.json");
    EXPECT_THAT(rows, HasSubstr("triangles"));
    EXPECT_EQ(run({"in.yarte", "strict.yarte", "--tessellate", "--strict"}).exitCode, 1);
    EXPECT_EQ(run({"in.yarte", "a.yarte", "--tessellate", "--canonical"}).exitCode, 2);
    // The finer, the more triangles; none is farther away than was asked for.
    std::size_t last = 0;
    for (const char* error : {"0.5", "0.05", "0.005"}) {
        const Converted converted = [&] {
            Options fine = options(folder_ / "in.yarte", folder_ / "fine.yarte");
            fine.writing.tessellate = true;
            fine.writing.chordError = std::stod(error);
            return Converted(fine);
        }();
        const std::size_t size = converted.files.at(1).bytes.size();
        EXPECT_GT(size, 2 * last) << error;
        last = size;
        for (const LedgerRow& row : converted.ledger.rows())
            if (row.property == "surface") {
                EXPECT_LE(row.bound.value(), std::stod(error)) << row.where;
            }
    }
}

TEST_F(YarteConvert, WritesToStandardOutput) {
    const ProgramResult result = run({shapes, "-", "--to", "pov"});
    EXPECT_EQ(result.exitCode, 0) << result.err;
    EXPECT_EQ(result.out, readFile(goldenFolder / "shapes.pov"));
    EXPECT_TRUE(left().empty());
}

TEST_F(YarteConvert, ReadsStandardInput) {
    const std::string command = "cd '" + goldenFolder.string() + "' && '" + YARTE_BIN_DIR +
                                "/yarte-convert' - '" + (folder_ / "out.yarte").string() +
                                "' --from yarte --canonical < meshes.yarte";
    ASSERT_EQ(std::system(command.c_str()), 0);
    EXPECT_THAT(bytes("out.yarte"), HasSubstr("mesh flat.pmf"));
}

TEST_F(YarteConvert, RefusesMeshFilesOnStandardOutput) {
    const ProgramResult result = run({meshes, "-", "--to", "yarte"});
    EXPECT_EQ(result.exitCode, 1);
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(result.err,
              "error: the scene has meshes, which need files of their own: name an output file, or use "
              "--canonical [convert.several-files]\n");
}

TEST_F(YarteConvert, ScalesTheExposure) {
    EXPECT_EQ(run({shapes, "out.pov", "--exposure", "0.25"}).exitCode, 0);
    EXPECT_THAT(bytes("out.pov"), HasSubstr("#declare Exposure = 0.25;"));
}

TEST_F(YarteConvert, ReportsLossAndIsStrictOnRequest) {
    const ProgramResult loose = run({meshes, "out.pov", "--plain-textures", "--report", "report.json"});
    EXPECT_EQ(loose.exitCode, 0);
    EXPECT_EQ(loose.err,
              meshes +
                  ": warning: material 2: transmission approximated: total internal reflection has "
                  "weight 1 [convert.loss]\n" +
                  meshes +
                  ": warning: body 3, back: transmission approximated: total internal reflection "
                  "has weight 1 [convert.loss]\n");
    EXPECT_THAT(bytes("report.json"), HasSubstr("\"action\": \"approximated\""));

    EXPECT_EQ(run({meshes, "strict.pov", "--plain-textures", "--strict"}).exitCode, 1);
    EXPECT_EQ(run({meshes, "exact.pov", "--strict"}).exitCode, 0);
    EXPECT_EQ(left(), (std::vector<std::string>{"exact.pov", "out.pov", "report.json", "strict.pov"}));
}

TEST_F(YarteConvert, RefusesAnInvalidScene) {
    writeFile(folder_ / "bad.yarte", "camera_position 0 0 5\nfocus_point 0 0 0\nspere 0 0 0 1\n");
    const ProgramResult result = run({"bad.yarte", "out.pov"});
    EXPECT_EQ(result.exitCode, 1);
    EXPECT_THAT(result.err, StartsWith("bad.yarte:3:1: error: "));
    EXPECT_EQ(left(), std::vector<std::string>{"bad.yarte"});

    const ProgramResult json = run({"bad.yarte", "out.pov", "--diagnostics", "json"});
    EXPECT_EQ(json.exitCode, 1);
    EXPECT_THAT(json.err, StartsWith("{"));
}

TEST_F(YarteConvert, ReadsMeshesOutsideTheFolderOnlyWhenAllowed) {
    std::filesystem::create_directories(folder_ / "a");
    std::filesystem::create_directories(folder_ / "b");
    std::filesystem::copy_file(goldenFolder / "flat.pmf", folder_ / "b/flat.pmf");
    writeFile(folder_ / "a/scene.yarte", "camera_position 0 0 5\nfocus_point 0 0 0\nlight_source 1 1 1 1\n"
                                         "material 1 1 1 1 1 1 0 0 0 1 0 0 0\n"
                                         "mesh ../b/flat.pmf 1 1 0 0 0 1 0 0 0 1 0 0 0\n");
    EXPECT_EQ(run({"a/scene.yarte", "out.pov"}).exitCode, 1);
    EXPECT_EQ(run({"a/scene.yarte", "out.pov", "--allow-path", "b"}).exitCode, 0);
    EXPECT_TRUE(std::filesystem::exists(folder_ / "out.pov"));
}

TEST_F(YarteConvert, LetsAScenesProgramWriteOnlyWhereItIsTold) {
    std::filesystem::create_directory(folder_ / "b");
    writeFile(folder_ / "scene.pov", "#fopen F \"made.inc\" write #write (F, \"sphere { 0, 1 }\") #fclose F\n"
                                     "#include \"made.inc\"\n");
    const ProgramResult refused = run({"scene.pov", "out.yarte"});
    EXPECT_EQ(refused.exitCode, 1);
    EXPECT_THAT(refused.err, HasSubstr("--allow-write"));
    EXPECT_EQ(run({"scene.pov", "out.yarte", "--allow-write", "b"}).exitCode, 0);
    EXPECT_EQ(bytes("b/made.inc"), "sphere { 0, 1 }");
    EXPECT_THAT(bytes("out.yarte"), HasSubstr("sphere"));
    EXPECT_EQ(run({"scene.pov", "out.yarte", "--allow-write", "no/such"}).exitCode, 3);
    EXPECT_EQ(left(), (std::vector<std::string>{"b", "out.yarte", "scene.pov"}));
}

TEST_F(YarteConvert, CannotRunWithoutItsFiles) {
    const ProgramResult missing = run({"missing.yarte", "out.pov"});
    EXPECT_EQ(missing.exitCode, 3);
    EXPECT_THAT(missing.err, StartsWith("yarte-convert: error: missing.yarte: "));
    EXPECT_EQ(run({".", "out.pov", "--from", "yarte"}).exitCode, 3);
    EXPECT_EQ(run({shapes, "no/such/folder/out.pov"}).exitCode, 3);
    EXPECT_TRUE(left().empty());
}

TEST_F(YarteConvert, LeavesTheOldOutputWhenTheDiskIsFull) {
    writeFile(folder_ / "out.pov", "old");
    const ProgramResult result =
        yarte::test::run("yarte-convert", {shapes, "out.pov"}, folder_, {}, {.fileSize = 100});
    EXPECT_EQ(result.exitCode, 3);
    EXPECT_EQ(bytes("out.pov"), "old");
    EXPECT_EQ(left(), std::vector<std::string>{"out.pov"});
}

TEST_F(YarteConvert, SaysWhatIsWrongWithItsUse) {
    const auto usage = [&](const std::vector<std::string>& arguments) {
        const ProgramResult result = run(arguments);
        EXPECT_EQ(result.exitCode, 2) << result.err;
        EXPECT_EQ(result.out, "");
        return result.err;
    };
    const std::string help = "\nSee yarte-convert --help\n";
    EXPECT_EQ(usage({}), "yarte-convert: IN: required" + help);
    EXPECT_EQ(usage({shapes}), "yarte-convert: OUT: required" + help);
    EXPECT_EQ(usage({shapes, "out.stl"}),
              "yarte-convert: out.stl: unknown extension; name the format with --to" + help);
    EXPECT_EQ(usage({shapes, "out", "--to", "stl"}),
              "yarte-convert: --to: unknown format 'stl'; see --list-formats" + help);
    EXPECT_EQ(usage({"a.pov", "b.yarte", "--size", "640"}),
              "yarte-convert: --size: expected WxH, like 640x480, got '640'" + help);
    EXPECT_EQ(usage({"-", "b.pov"}), "yarte-convert: --from: needed to say the format of '-'" + help);
    EXPECT_EQ(usage({shapes, "-"}), "yarte-convert: --to: needed to say the format of '-'" + help);
    EXPECT_EQ(usage({shapes, "a.pov", "--canonical"}),
              "yarte-convert: --canonical: both files must be .yarte" + help);
    EXPECT_EQ(usage({shapes, "a.pov", "--exposure", "0"}),
              "yarte-convert: --exposure: must be positive" + help);
    EXPECT_EQ(usage({shapes, "a.pov", "--exposure", "nan"}),
              "yarte-convert: --exposure: must be positive" + help);
    EXPECT_THAT(usage({shapes, "a.pov", "--frobnicate"}), HasSubstr("--frobnicate"));
    EXPECT_TRUE(left().empty());
}

TEST_F(YarteConvert, AnswersQuestionsAboutItself) {
    EXPECT_EQ(run({"--list-formats"}).out, listFormats());
    EXPECT_EQ(run({"--version"}).out, std::string("yarte-convert ") + version + "\n");
    const ProgramResult help = run({"--help"});
    EXPECT_EQ(help.exitCode, 0);
    EXPECT_THAT(help.out, HasSubstr("--plain-textures"));
}

} // namespace
} // namespace yarte::convert::test
