// glTF and GLB as a scene; buffers in files are not there.
#include "tests/fuzz/target.h"

#include "convert/gltf/read.h"

#include <cstdlib>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    yarte::Sources sources;
    yarte::Diagnostics diagnostics;
    yarte::convert::Ledger ledger;
    const auto id = sources.add("/nowhere/a.gltf", std::string(yarte::fuzz::textOf(data, size)));
    yarte::convert::Conversion conversion{
        {id, "/nowhere/a.gltf", {}, {}}, "/nowhere/b.yarte", {}, sources, diagnostics, ledger};
    const auto scene = yarte::convert::gltf::readScene(conversion);
    if (!scene && diagnostics.all().empty()) std::abort(); // refused without a word
    format(diagnostics, sources, yarte::DiagnosticStyle::plain);
    return 0;
}
