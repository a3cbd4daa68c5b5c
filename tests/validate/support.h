// Small pictures, scratch folders and sample reports for the validator's tests.
#pragma once

#include "validate/picture.h"
#include "validate/report.h"
#include "yarte/base/file.h"

#include <filesystem>
#include <gtest/gtest.h>
#include <string>

namespace yarte::validate::test {

inline Picture constantPicture(int width, int height, Colour colour) {
    return {width, height, std::vector<Colour>(static_cast<std::size_t>(width * height), colour)};
}

/// A new, empty folder of the running test's own.
inline std::filesystem::path scratchFolder() {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    const auto folder =
        std::filesystem::path(YARTE_TEST_OUTPUT) / "validate" / test->test_suite_name() / test->name();
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    return folder;
}

/// One case of each verdict, with everything in it that must be escaped somewhere.
inline Report sampleReport() {
    CaseReport pass;
    pass.name = "paper";
    pass.source = "scenes/paper/paper.yarte";
    pass.sides[0] = "YARTE";
    pass.sides[1] = "POV-Ray";
    pass.verdict = Verdict::pass;
    pass.width = 256;
    pass.height = 128;
    pass.exposure = 0.5;
    pass.comparison = {{7.5e-6, {3, 4}}, 2.5e-6, 112.04, {0.00025, 0.125, {5, 6}}, 0.0001, 0};
    pass.yarte = {0.125, 0.25};
    pass.povray = {0.5, 0.75, 1.5, true};
    pass.commands = {{"yarte 'a b.yarte' -o yarte.pfm", 0.25, "exit code 0"}};
    pass.pictures = {{"YARTE", "yarte.png"}};

    CaseReport fail = pass;
    fail.name = "glass";
    fail.verdict = Verdict::fail;
    fail.message = "2 of 32768 pixels differ";
    fail.comparison->psnr.reset();
    fail.comparison->pixelsOver = 2;
    fail.povray.trace.reset();
    fail.povray.cached = false;
    fail.pictures.clear();
    Region region;
    region.box = {10, 20, 12, 21};
    region.pixels = 2;
    region.maxError = 0.25;
    region.maxErrorAt = {11, 20};
    region.finding = {Cause::body,         3,  {},
                      "sphere at line 23", 23, "the sphere at line 23 is missing or moved"};
    fail.explanation = {region.finding, {region}};
    fail.tolerance = "tolerance.json";
    fail.conditions = {{0, false, true, "all", 0, 0, "", ""},
                       {1, false, false, "max_abs <= 4/65535", 0.25, 4.0 / 65535, "glass", "/all/0"}};

    CaseReport error;
    error.name = "broken";
    error.source = "a|b & <c>.yarte";
    error.message = "yarte: exit code 1\n</script> & \"quotes\" | pipes";
    return {"0.1.0", "Linear", "POV-Ray", 2, {pass, fail, error}};
}

} // namespace yarte::validate::test
