#include "convert/convert.h"

#include "convert/curved_shapes.h"

namespace yarte::convert {

std::vector<OutputFile> convert(const Options& options, Sources& sources, Diagnostics& diagnostics,
                                Ledger& ledger) {
    const bool isStandardInput = options.input.empty();
    std::string bytes = readFile(isStandardInput ? "/dev/stdin" : options.input);
    const std::string name = isStandardInput ? "<stdin>" : options.input.string();
    Conversion conversion{
        .input = {sources.add(name, std::move(bytes)),
                  options.input,
                  {options.allowedFolders},
                  options.writableFolder},
        .output = options.output,
        .options = options.writing,
        .sources = sources,
        .diagnostics = diagnostics,
        .ledger = ledger,
    };
    std::optional<Scene> scene = options.from->read(conversion);
    if (!scene) return {};
    if (options.writing.tessellate)
        scene = withMeshesForCurvedShapes(std::move(*scene), options.writing.chordError, ledger);
    std::vector<OutputFile> files = options.to->write(*scene, conversion);
    for (const LedgerRow& row : ledger.rows())
        if (isLoss(row.action)) diagnostics.warning("convert.loss", describe(row)).file = name;
    if (files.size() > 1 && options.output.empty()) {
        diagnostics.error("convert.several-files",
                          "the scene has meshes, which need files of their own: name an "
                          "output file, or use --canonical");
        return {};
    }
    return files;
}

} // namespace yarte::convert
