// The scene language. What reads well is printed and read again: it must be the same scene.
#include "tests/fuzz/target.h"

#include "yarte/lang/scene_printer.h"
#include "yarte/lang/scene_reader.h"

#include <cstdlib>
#include <string>

namespace {

std::optional<yarte::Scene> sceneOf(std::string text) {
    yarte::Sources sources;
    yarte::Diagnostics diagnostics;
    const auto id = sources.add("scene.yarte", std::move(text));
    auto scene = yarte::parseScene(id, "/nowhere", {}, sources, diagnostics);
    if (!scene && diagnostics.all().empty()) std::abort(); // refused without a word
    format(diagnostics, sources, yarte::DiagnosticStyle::plain);
    return scene;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto scene = sceneOf(std::string(yarte::fuzz::textOf(data, size)));
    if (!scene) return 0;
    const std::string printed = yarte::printScene(*scene);
    const auto again = sceneOf(printed);
    if (!again || yarte::printScene(*again) != printed) std::abort();
    return 0;
}
