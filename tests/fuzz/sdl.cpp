// POV-Ray's language, from tokens to the scene that becomes of it. Programs get a small part of the steps
// that a user's get: a loop without end is not a find.
#include "tests/fuzz/target.h"

#include "convert/povray/sdl/build_scene.h"
#include "tests/convert/povray/sdl/run.h"

#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    namespace sdl = yarte::convert::povray::sdl;
    sdl::Limits limits;
    limits.tokens = 20'000;
    limits.elements = 20'000;
    limits.stringLength = 20'000;
    limits.objects = 2'000;
    sdl::test::SdlRun run(std::string(yarte::fuzz::textOf(data, size)), "/nowhere/scene.pov", limits);
    if (!run.model && run.diagnostics.all().empty()) std::abort(); // refused without a word
    run.problems();
    if (!run.model) return 0;
    yarte::convert::Ledger ledger;
    // Coarse, so that round shapes that must become triangles become few.
    sdl::buildScene(*run.model, {0.5, {64, 48}}, run.sources, run.diagnostics, ledger);
    return 0;
}
