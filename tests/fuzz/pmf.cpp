// .pmf meshes. What reads well is printed and read again: it must be the same mesh.
#include "tests/fuzz/target.h"

#include "yarte/lang/pmf.h"

#include <cstdlib>
#include <string>

namespace {

std::optional<yarte::MeshData> meshOf(std::string text) {
    yarte::Sources sources;
    yarte::Diagnostics diagnostics;
    auto mesh = yarte::parsePmf(sources.add("mesh.pmf", std::move(text)), sources, diagnostics);
    if (!mesh && diagnostics.all().empty()) std::abort(); // refused without a word
    format(diagnostics, sources, yarte::DiagnosticStyle::plain);
    return mesh;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto mesh = meshOf(std::string(yarte::fuzz::textOf(data, size)));
    if (!mesh) return 0;
    const std::string printed = yarte::printPmf(*mesh);
    const auto again = meshOf(printed);
    if (!again || yarte::printPmf(*again) != printed) std::abort();
    return 0;
}
