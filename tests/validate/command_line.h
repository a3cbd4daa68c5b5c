// The program yarte-validate as users run it, with fake renderers: shell scripts that the tests write.
#pragma once

#include "tests/validate/support.h"
#include "validate/program.h"

#include <string>
#include <vector>

namespace yarte::validate::test {

/// Writes a 2x1 PFM to the file after -o, and statistics. $PIXELS: six floats, little-endian, as printf's
/// escapes.
inline constexpr const char* fakeYarte = R"sh(#!/bin/sh
while [ $# -gt 0 ]; do case $1 in -o) out=$2 ;; --stats) stats=$2 ;; esac; shift; done
printf 'PF\n2 1\n-1.0\nPIXELS' > "$out"
echo '{"trace_s": 0.125}' > "$stats"
)sh";

/// Black, then (0, 0.5, 1).
inline const std::string dimPixels = R"(\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\077\0\0\200\077)";
/// Black, then (0, 0.5, 4).
inline const std::string brightPixels = R"(\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\077\0\0\200\100)";
/// Black, then (0, 0.5, nan).
inline const std::string nanPixels = R"(\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\077\0\0\300\177)";

inline constexpr const char* fakeConvert = "#!/bin/sh\necho \"// $3 $4\" > \"$2\"\n";

inline constexpr const char* fakePovray = R"sh(#!/bin/sh
for a; do case $a in +O*) out=${a#+O} ;; +GS*) stats=${a#+GS} ;; esac; done
printf 'P6\n2 1\n65535\nPIXELS' > "$out"
printf '  Parse Time: 0 seconds (0.002 seconds)\n  Trace Time: 0 seconds (0.250 seconds)\n' > "$stats"
)sh";

/// Black, then (0, 0x8000, 0xffff): half a step from dimPixels.
inline const std::string dimSteps = R"(\0\0\0\0\0\0\0\0\200\0\377\377)";
/// A quarter of brightPixels: (0, 0x2000, 0xffff).
inline const std::string brightSteps = R"(\0\0\0\0\0\0\0\0\040\0\377\377)";
/// Five steps too much in one channel.
inline const std::string wrongSteps = R"(\0\0\0\0\0\0\0\0\200\005\377\377)";

inline std::string with(std::string script, const std::string& pixels) {
    return script.replace(script.find("PIXELS"), 6, pixels);
}

class CommandLine : public testing::Test {
protected:
    void SetUp() override {
        if (!std::filesystem::exists(program_)) GTEST_FAIL() << program_ << " is not built";
        std::filesystem::create_directory(folder_ / "tmp");
        writeFile(folder_ / "scene.yarte", "");
        install("yarte", with(fakeYarte, dimPixels));
        install("yarte-convert", fakeConvert);
        install("povray", with(fakePovray, dimSteps));
    }
    void install(const std::string& name, const std::string& script) {
        writeFile(folder_ / name, script);
        std::filesystem::permissions(folder_ / name, std::filesystem::perms::owner_all);
    }
    /// Runs yarte-validate in the test's folder; its standard output is then `output_`, its exit code the
    /// result.
    int validate(const std::vector<std::string>& arguments,
                 const std::vector<std::string>& environment = {}) {
        ProgramRun program{{"/bin/sh", "-c", "exec \"$0\" \"$@\" >stdout", program_},
                           folder_,
                           {"TMPDIR=" + (folder_ / "tmp").string(), "PATH=/nowhere"},
                           300, // not a promise: sanitizers on a busy machine are slow
                           0,
                           0};
        program.command.insert(program.command.end(), arguments.begin(), arguments.end());
        program.environment.insert(program.environment.end(), environment.begin(), environment.end());
        const ProgramResult result = run(program, stop_);
        EXPECT_EQ(result.signal, 0);
        EXPECT_FALSE(result.timedOut);
        EXPECT_TRUE(std::filesystem::is_empty(folder_ / "tmp")) << "temporary files are left";
        output_ = readFile(folder_ / "stdout");
        errors_ = result.errorText;
        return result.exitCode;
    }
    int validateScenes(const std::vector<std::string>& scenes, const std::vector<std::string>& more = {},
                       const std::vector<std::string>& environment = {}) {
        std::vector<std::string> arguments = scenes;
        arguments.insert(arguments.end(),
                         {"-o", "out", "--yarte", "./yarte", "--convert", "./yarte-convert"});
        arguments.insert(arguments.end(), {"--povray", "./povray"});
        arguments.insert(arguments.end(), more.begin(), more.end());
        return validate(arguments, environment);
    }
    std::string report() const { return readFile(folder_ / "out/report.json"); }
    bool wrote(const std::string& file) const { return std::filesystem::exists(folder_ / "out" / file); }

    const std::string program_ = YARTE_BIN_DIR "/yarte-validate";
    std::filesystem::path folder_ = test::scratchFolder();
    StopSignal stop_;
    std::string output_, errors_;
};

} // namespace yarte::validate::test
