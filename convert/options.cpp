#include "convert/options.h"

#include "yarte/base/integers.h"
#include "yarte/scene/check.h"
#include "yarte/version.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <cmath>

namespace yarte::convert {
namespace {

/// The command line's options as CLI11 fills them in, where they are not yet those of Options.
struct Raw {
    std::string input, output, from, to, report, size, writableFolder, diagnostics = "text";
    std::vector<std::string> allowedFolders;
    bool listFormats = false;
};

void declare(CLI::App& app, Raw& raw, Options& options) {
    app.get_formatter()->column_width(30);
    app.set_version_flag("--version", fmt::format("yarte-convert {}", version), "Print the version and exit");
    app.add_option("IN", raw.input, "File to read; -: standard input, with --from")->type_name("");
    app.add_option("OUT", raw.output, "File to write; -: standard output, with --to")->type_name("");
    app.add_option("--from", raw.from, "Format of IN, instead of by its extension")->type_name("FORMAT");
    app.add_option("--to", raw.to, "Format of OUT, instead of by its extension")->type_name("FORMAT");
    app.add_flag("--list-formats", raw.listFormats, "Print the formats and exit");
    app.add_option("--report", raw.report, "Write the ledger of what was kept and what was lost, as JSON")
        ->type_name("FILE");
    app.add_flag("--strict", options.strict, "Exit with 1 if anything is approximated or dropped");
    app.add_flag("--canonical", options.writing.canonical,
                 "Print a .yarte scene as canonical .yarte text; its mesh files stay where they are");
    app.add_option("--exposure", options.writing.exposure,
                   "Factor of all light in .pov, to stay below a picture file's white; best a power of two")
        ->type_name("S")
        ->capture_default_str();
    app.add_flag("--plain-textures", options.writing.plainTextures,
                 "Write .pov with the textures and meshes that POV-Ray renders fastest, not the exact ones");
    app.add_flag("--tessellate", options.writing.tessellate,
                 "Write meshes of triangles for curved shapes in formats that need none, too");
    app.add_option("--chord-error", options.writing.chordError,
                   "How far triangles may be from curved shapes, where they become such (.gltf, .glb, "
                   "--tessellate), in scene units; default: a thousandth of the radius")
        ->type_name("E");
    app.add_option("--size", raw.size,
                   "Size of the picture of a .pov scene, which does not say it; default: 640x480")
        ->type_name("WxH");
    app.add_option("--allow-path", raw.allowedFolders,
                   "Folder besides the input's own that it may read files from; may be repeated")
        ->type_name("DIR")
        ->allow_extra_args(false);
    app.add_option("--allow-write", raw.writableFolder,
                   "Folder that a .pov scene may write files in, by #fopen; default: it may not")
        ->type_name("DIR");
    app.add_option("--diagnostics", raw.diagnostics, "How errors and warnings are printed")
        ->type_name("text|json")
        ->check(CLI::Validator(CLI::IsMember({"text", "json"})).description(""));
}

/// The format that the user named, or that of the file; throws CLI::ValidationError.
const Format* chooseFormat(const std::string& option, const std::string& named, const std::string& file) {
    if (!named.empty()) {
        if (const Format* format = formatNamed(named)) return format;
        throw CLI::ValidationError(option, fmt::format("unknown format '{}'; see --list-formats", named));
    }
    if (file == "-") throw CLI::ValidationError(option, "needed to say the format of '-'");
    if (const Format* format = formatOf(file)) return format;
    throw CLI::ValidationError(file, fmt::format("unknown extension; name the format with {}", option));
}

/// Throws CLI::ValidationError.
void complete(Options& options, const Raw& raw) {
    if (raw.input.empty()) throw CLI::ValidationError("IN", "required");
    if (raw.output.empty()) throw CLI::ValidationError("OUT", "required");
    options.from = chooseFormat("--from", raw.from, raw.input);
    options.to = chooseFormat("--to", raw.to, raw.output);
    if (!options.from->read)
        throw CLI::ValidationError(raw.input,
                                   fmt::format("format '{}' can only be written", options.from->name));
    if (!options.to->write)
        throw CLI::ValidationError(raw.output, fmt::format("format '{}' can only be read", options.to->name));
    if (options.writing.canonical && (options.from->name != "yarte" || options.to->name != "yarte"))
        throw CLI::ValidationError("--canonical", "both files must be .yarte");
    if (options.writing.tessellate && options.writing.canonical)
        throw CLI::ValidationError("--tessellate", "makes meshes, which --canonical does not write");
    if (!(options.writing.exposure > 0) || !std::isfinite(options.writing.exposure))
        throw CLI::ValidationError("--exposure", "must be positive");
    if (const auto chord = options.writing.chordError; chord && !(*chord > 0 && std::isfinite(*chord)))
        throw CLI::ValidationError("--chord-error", "must be positive");
    if (!raw.size.empty()) {
        const auto sides = parseIntegers<2>(raw.size, 'x');
        if (!sides || !check(Resolution{(*sides)[0], (*sides)[1]}).empty())
            throw CLI::ValidationError("--size",
                                       fmt::format("expected WxH, like 640x480, got '{}'", raw.size));
        options.writing.size = {(*sides)[0], (*sides)[1]};
    }
    if (raw.input != "-") options.input = raw.input;
    if (raw.output != "-") options.output = raw.output;
    options.allowedFolders.assign(raw.allowedFolders.begin(), raw.allowedFolders.end());
    if (!raw.writableFolder.empty()) options.writableFolder = raw.writableFolder;
    if (!raw.report.empty()) options.report = raw.report;
    options.jsonDiagnostics = raw.diagnostics == "json";
}

} // namespace

ParsedOptions parseOptions(int argc, const char* const* argv) {
    CLI::App app("Converts scenes and meshes from one format to another.", "yarte-convert");
    Raw raw;
    Options options;
    declare(app, raw, options);
    try {
        app.parse(argc, argv);
        if (raw.listFormats) return {std::nullopt, listFormats(), 0};
        complete(options, raw);
    } catch (const CLI::CallForHelp&) {
        return {std::nullopt, app.help(), 0};
    } catch (const CLI::CallForVersion& call) {
        return {std::nullopt, fmt::format("{}\n", call.what()), 0};
    } catch (const CLI::ParseError& error) {
        return {std::nullopt, fmt::format("yarte-convert: {}\nSee yarte-convert --help\n", error.what()), 2};
    }
    return {std::move(options), {}, 0};
}

} // namespace yarte::convert
