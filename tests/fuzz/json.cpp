// JSON: as glTF's reader takes it apart, and as a file of tolerances.
#include "tests/fuzz/target.h"

#include "convert/gltf/json.h"
#include "validate/tolerance_json.h"

#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text(yarte::fuzz::textOf(data, size));
    yarte::Diagnostics diagnostics;
    yarte::convert::gltf::parseJson(text, "a.gltf", diagnostics);
    try {
        yarte::validate::parseTolerance(text, "/nowhere/tolerance.json");
    } catch (const yarte::validate::ToleranceError&) {
    }
    return 0;
}
