// Files of others: they are read to their end, or refused for a reason that is known.
#include "tests/convert/povray/sdl/run.h"

#include "yarte/base/file.h"

#include <gtest/gtest.h>

#include <sstream>

namespace yarte::convert::povray::sdl::test {
namespace {

namespace fs = std::filesystem;

TEST(SdlCorpus, EveryFileIsReadToItsEnd) {
    if (std::string(YARTE_CORPORA).empty()) GTEST_SKIP() << "skipped: YARTE_CORPORA is empty";
    int count = 0;
    for (const char* folder : {"spd", "povray"})
        for (const auto& entry : fs::directory_iterator(fs::path(YARTE_CORPORA) / folder)) {
            if (entry.path().extension() != ".pov") continue;
            ++count;
            const Run run(readFile(entry.path()), entry.path());
            // Open Babel's own include file is not part of what it wrote.
            if (run.problems().find("babel_povray3.inc") != std::string::npos) continue;
            EXPECT_TRUE(run.model) << entry.path() << '\n' << run.problems();
        }
    EXPECT_GE(count, 30);
}

TEST(SdlCorpus, ScenesOfDebiansExamplesAreReadToTheirEnd) {
    const fs::path examples = "/usr/share/doc/povray";
    if (std::string(YARTE_CORPORA).empty() || !fs::exists(examples / "examples"))
        GTEST_SKIP() << "skipped: YARTE_CORPORA is empty, or povray-examples is not installed";
    std::istringstream list(readFile(fs::path(YARTE_CORPORA) / "povray/debian-examples-open.txt"));
    int count = 0, open = 0;
    std::string failed;
    for (std::string name; list >> name;) {
        Limits limits;
        limits.tokens = 10'000'000; // some run for long
        const Run run(readFile(examples / name), examples / name, limits);
        ++count;
        open += run.model.has_value();
        if (!run.model) failed += run.problems();
    }
    EXPECT_GE(count, 180);
    EXPECT_GE(open, count * 95 / 100) << failed;
}

} // namespace
} // namespace yarte::convert::povray::sdl::test
