// read_alone mesh|scene FILE: reads a .pmf or glTF file as the `mesh` directive does, or a file of any format
// as a scene, and nothing else. Prints the seconds from opening the file to the finished scene, and the
// process's peak of memory in MB.
#include "convert/format.h"
#include "convert/gltf/mesh_reader.h"
#include "yarte/lang/pmf.h"

#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <string_view>

#include <sys/resource.h>

namespace {

using namespace yarte;

/// The number of triangles; 0 if the file cannot be read.
std::size_t readAs(std::string_view what, const std::filesystem::path& file) {
    Sources sources;
    Diagnostics diagnostics;
    if (what == "mesh") {
        const auto read = file.extension() == ".pmf" ? readPmf : convert::gltf::readMesh;
        const auto mesh = read(file, {}, sources, diagnostics);
        return mesh ? mesh->faceCount() : 0;
    }
    const convert::Format* format = convert::formatOf(file);
    if (!format || !format->read) return 0;
    convert::Ledger ledger;
    convert::Conversion c{
        {sources.add(file.string(), readFile(file)), file, {}}, {}, {}, sources, diagnostics, ledger};
    const auto scene = format->read(c);
    std::size_t count = 0;
    if (scene)
        for (const MeshData& mesh : scene->meshes) count += mesh.faceCount();
    return count;
}

} // namespace

int main(int argc, char** argv) {
    if (argc != 3) return 2;
    const auto begin = std::chrono::steady_clock::now();
    const std::size_t triangles = readAs(argv[1], argv[2]);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    fmt::print("{:.4f} {:.1f}\n", seconds.count(), static_cast<double>(usage.ru_maxrss) * 1024 / 1e6);
    return triangles > 0 ? 0 : 1;
}
