// What the tests of the program `yarte` share: it runs in an empty folder of the test's own.
#pragma once

#include "tests/support/program.h"

#include "yarte/base/file.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

namespace yarte::test {

namespace fs = std::filesystem;

inline const std::string paper = std::string(YARTE_SOURCE_DIR) + "/scenes/paper/paper.yarte";

inline constexpr const char* sphereScene = "image_resolution 16 12\n"
                                           "camera_position 0 0 5\n"
                                           "focus_point 0 0 0\n"
                                           "light_source 5 5 5 1\n"
                                           "material 0.2 0.2 0.2 0.5 0.5 0.5 0.5 0.5 0.5 20 0 0 0\n"
                                           "sphere 0 0 0 2\n";

class Yarte : public testing::Test {
protected:
    ProgramResult yarte(const std::vector<std::string>& arguments,
                        const std::vector<std::string>& environment = {}) const {
        return run("yarte", arguments, folder_, environment);
    }

    /// yarte, which must succeed in silence.
    void render(const std::vector<std::string>& arguments) const {
        const ProgramResult result = yarte(arguments);
        ASSERT_EQ(result.exitCode, 0) << result.err;
        EXPECT_EQ(result.out + result.err, "");
    }

    void write(const std::string& name, const std::string& text) const { writeFile(folder_ / name, text); }
    std::string bytes(const std::string& name) const { return readFile(folder_ / name); }

    const fs::path folder_ = emptyTestFolder();
};

} // namespace yarte::test
