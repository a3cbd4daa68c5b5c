// glTF and GLB as the `mesh` directive of a scene reads them. What is read is a mesh that passes its checks
// or is refused by them.
#include "tests/fuzz/scratch.h"
#include "tests/fuzz/target.h"

#include "convert/gltf/mesh_reader.h"
#include "yarte/scene/check.h"

#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const yarte::fuzz::Scratch scratch;
    yarte::Sources sources;
    yarte::Diagnostics diagnostics;
    const auto mesh = yarte::convert::gltf::readMesh(scratch.put("a.gltf", yarte::fuzz::textOf(data, size)),
                                                     {}, sources, diagnostics);
    if (!mesh && diagnostics.all().empty()) std::abort(); // refused without a word
    format(diagnostics, sources, yarte::DiagnosticStyle::plain);
    if (mesh) check(*mesh);
    return 0;
}
