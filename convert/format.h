// The table of formats. A format is two free functions; what every one of them reads to and writes from is
// yarte::Scene. To add one: write its reader or writer in a folder of its own, and add a line to the table in
// format.cpp.
#pragma once

#include "convert/ledger.h"
#include "yarte/base/diagnostic.h"
#include "yarte/base/file.h"
#include "yarte/scene/scene.h"

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace yarte::convert {

/// What is read: a text (or bytes) that is in `sources` already.
struct Input {
    SourceId text;
    std::filesystem::path file;                      ///< empty: standard input
    ReadableFolders readable;                        ///< besides the file's own folder
    std::optional<std::filesystem::path> writable{}; ///< where a .pov program may write files; none: nowhere

    /// Where relative paths in the text start.
    std::filesystem::path folder() const { return file.has_parent_path() ? file.parent_path() : "."; }
};

struct WriteOptions {
    double exposure = 1; ///< .pov: factor of lights, ambient and background; a power of two keeps every bit
    bool plainTextures = false; ///< .pov: the fastest idiomatic SDL rather than the exact one
    bool tessellate = false;    ///< curved shapes become meshes, whatever the format
    /// How far triangles may be from curved shapes, in scene units; none: defaultChordError of the radius
    std::optional<double> chordError{};
    Resolution size{640, 480}; ///< of a .pov scene, which does not say it itself
    bool canonical = false;    ///< .yarte: mesh paths stay as they are and no mesh is written
};

struct OutputFile {
    std::filesystem::path file; ///< empty: standard output
    std::string bytes;
};

/// The state of one conversion, shared by the reader and the writer.
struct Conversion {
    Input input;
    std::filesystem::path output; ///< empty: standard output
    WriteOptions options;
    Sources& sources;
    Diagnostics& diagnostics;
    Ledger& ledger;
};

struct Format {
    std::string_view name;
    std::vector<std::string_view> extensions; ///< with the dot, lower case
    /// The scene, or nothing after reporting why. Null: the format is not read.
    std::optional<Scene> (*read)(Conversion&);
    /// The files to write, the main one first; none after an error was reported. Null: the format is not
    /// written.
    std::vector<OutputFile> (*write)(const Scene&, Conversion&);
};

std::span<const Format> formats();

/// By name ("pov"), or by a file's extension in any case; null if there is none.
const Format* formatNamed(std::string_view name);
const Format* formatOf(const std::filesystem::path& file);

/// One line per format: name, extensions, what can be done with it.
std::string listFormats();

} // namespace yarte::convert
