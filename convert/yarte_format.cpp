#include "convert/yarte_format.h"

#include "convert/gltf/mesh_reader.h"
#include "yarte/lang/pmf.h"
#include "yarte/lang/scene_printer.h"
#include "yarte/lang/scene_reader.h"

#include <fmt/format.h>

namespace yarte::convert {
namespace {

constexpr MeshFormat meshFormats[] = {{".pmf", readPmf}, {".gltf", gltf::readMesh}, {".glb", gltf::readMesh}};

std::filesystem::path folderOf(const std::filesystem::path& file) {
    return std::filesystem::weakly_canonical(std::filesystem::absolute(file)).parent_path();
}

/// True if the mesh's path, seen from the output, names a file with just this content.
bool isInPlace(const MeshData& mesh, const Conversion& conversion) {
    if (mesh.path.empty() || conversion.input.file.empty() || conversion.output.empty()) return false;
    const std::filesystem::path folder = folderOf(conversion.output);
    if (folder != folderOf(conversion.input.file)) return false;
    const std::filesystem::path file = folder / mesh.path;
    if (formatOf(file) == nullptr || formatOf(file)->name != "pmf" || !std::filesystem::is_regular_file(file))
        return false;
    Sources sources;
    Diagnostics ignored; // a file that is no mesh is not this mesh
    ReadableFolders readable = conversion.input.readable;
    readable.folders.push_back(folder);
    std::optional<MeshData> there = readPmf(file, readable, sources, ignored);
    if (!there) return false;
    there->path = mesh.path;
    return *there == mesh;
}

/// A name without what would end a word of the scene language.
std::string word(std::string text) {
    for (char& c : text)
        if (c == ';' || static_cast<unsigned char>(c) <= ' ') c = '_';
    return text;
}

} // namespace

std::optional<Scene> readYarteScene(Conversion& c) {
    return parseScene(c.input.text, c.input.folder(), {c.input.readable, meshFormats}, c.sources,
                      c.diagnostics);
}

std::vector<OutputFile> writeYarteScene(const Scene& scene, Conversion& c) {
    Scene named = scene;
    std::vector<OutputFile> files{{c.output, {}}};
    for (std::size_t i = 0; i < named.meshes.size() && !c.options.canonical; ++i) {
        MeshData& mesh = named.meshes[i];
        if (isInPlace(mesh, c)) continue;
        mesh.path = fmt::format("{}.{}.pmf", word(c.output.stem().string()), i + 1);
        files.push_back({c.output.parent_path() / mesh.path, printPmf(mesh)});
        c.ledger.add({fmt::format("mesh {}", i + 1), "file", Action::exact, "written as " + mesh.path, {}});
    }
    files.front().bytes = printScene(named);
    c.ledger.add({"scene", "everything", Action::exact, "canonical text; comments are not kept", {}});
    return files;
}

} // namespace yarte::convert
