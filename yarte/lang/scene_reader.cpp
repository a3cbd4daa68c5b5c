#include "yarte/lang/scene_reader.h"

#include "yarte/lang/scene_builder.h"

#include <utility>

namespace yarte {

std::optional<Scene> parseScene(SourceId id, const std::filesystem::path& folder, const SceneReading& reading,
                                Sources& sources, Diagnostics& diagnostics) {
    const Source& text = sources[id];
    if (text.text().find('\0') != std::string_view::npos) {
        diagnostics.error("lang.binary-file", "the file is binary, not the text of a scene").file =
            text.name();
        return std::nullopt;
    }
    SceneBuilder builder(MeshFiles(folder, reading, sources, diagnostics), diagnostics);
    StatementParser parser(id, sources, diagnostics);
    for (Statement statement; !diagnostics.full() && parser.next(statement);) builder.add(statement);
    return std::move(builder).finish(text);
}

std::optional<Scene> readScene(const std::filesystem::path& file, const SceneReading& reading,
                               Sources& sources, Diagnostics& diagnostics) {
    const SourceId text = sources.add(file.string(), readFile(file));
    return parseScene(text, file.parent_path(), reading, sources, diagnostics);
}

} // namespace yarte
