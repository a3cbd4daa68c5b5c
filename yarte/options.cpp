#include "yarte/options.h"

#include "yarte/base/integers.h"
#include "yarte/scene/check.h"
#include "yarte/trace/supersample.h"
#include "yarte/version.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <array>
#include <optional>
#include <string_view>

namespace yarte {

namespace {

Resolution parseSize(const std::string& text) {
    const auto sides = parseIntegers<2>(text, 'x');
    if (!sides)
        throw CLI::ValidationError("--size", fmt::format("expected WxH, like 640x480, got '{}'", text));
    const Resolution size{(*sides)[0], (*sides)[1]};
    if (const Problems problems = check(size); !problems.empty())
        throw CLI::ValidationError("--size", problems.front().message);
    return size;
}

Tile parseRegion(const std::string& text) {
    const auto r = parseIntegers<4>(text, ',');
    if (!r) throw CLI::ValidationError("--region", fmt::format("expected X0,Y0,X1,Y1, got '{}'", text));
    const Tile region{(*r)[0], (*r)[1], (*r)[2], (*r)[3]};
    if (region.x0 < 0 || region.y0 < 0 || region.x0 >= region.x1 || region.y0 >= region.y1)
        throw CLI::ValidationError("--region", fmt::format("no pixel lies in '{}': it needs 0 <= X0 < X1 and "
                                                           "0 <= Y0 < Y1",
                                                           text));
    return region;
}

CLI::Validator wholeNumberFrom(int minimum, std::optional<int> maximum = std::nullopt) {
    return {[minimum, maximum](const std::string& text) {
                const auto number = parseIntegers<1>(text, ' ');
                if (number && (*number)[0] >= minimum && (*number)[0] <= maximum.value_or((*number)[0]))
                    return std::string();
                const std::string range = maximum ? fmt::format("from {} to {}", minimum, *maximum)
                                                  : fmt::format("of at least {}", minimum);
                return fmt::format("expected a whole number {}, got '{}'", range, text);
            },
            ""};
}

std::string checkOutput(const std::string& file) {
    if (imageFormat(file)) return {};
    return fmt::format("{}: unknown image format; known are {}", file, imageExtensions());
}

std::string checkAovFile(const std::string& file) {
    return imageFormat(file) == ImageFormat::exr ? std::string() : fmt::format("{}: must end in .exr", file);
}

/// The command line's options as CLI11 fills them in, where they are not yet those of Options.
struct Raw {
    std::string scene, size, region, stats, aov, hits, checkpoint;
    std::string precision = "double", progress = "auto", diagnostics = "text";
    std::vector<std::string> outputs, allowedFolders;
    std::optional<int> processes, threads;
};

void declare(CLI::App& app, Raw& raw, Options& options) {
    app.get_formatter()->column_width(30);
    app.set_version_flag("--version", fmt::format("yarte {}", version), "Print the version and exit");
    app.add_option("SCENE", raw.scene, "The scene to render")->required()->type_name("");
    app.add_option(
           "-o,--output", raw.outputs,
           fmt::format("Image to write, format by extension ({}); may be repeated. Default: the scene's "
                       "name with .png, in the working directory",
                       imageExtensions()))
        ->type_name("FILE")
        ->allow_extra_args(false)
        ->check(CLI::Validator(checkOutput, ""));
    app.add_option("--size", raw.size, "Image size in pixels, instead of the scene's image_resolution")
        ->type_name("WxH");
    app.add_option("--region", raw.region,
                   "Render these pixels only: zero-based, half-open; the output has the region's size")
        ->type_name("X0,Y0,X1,Y1");
    app.add_option("--precision", raw.precision,
                   "Numbers to compute in; fast: in float, for pictures that are only looked at")
        ->type_name("double|fast")
        ->capture_default_str()
        ->check(CLI::Validator(CLI::IsMember({"double", "fast"})).description(""));
    const auto processes =
        app.add_option("--processes", raw.processes,
                       "Worker processes; 0: render in this process. Default: one per core")
            ->type_name("N")
            ->check(wholeNumberFrom(0));
    app.add_option("--threads", raw.threads, "Render with N threads of this process instead")
        ->type_name("N")
        ->check(wholeNumberFrom(1))
        ->excludes(processes);
    app.add_option("--tile", options.tileSide,
                   "Side in pixels of the tiles dealt to workers; changes no pixel. Default: 32, or 16 for "
                   "many workers")
        ->type_name("N")
        ->check(wholeNumberFrom(1));
    app.add_option("--samples", options.samples, "Rays a pixel, N x N: antialiasing")
        ->type_name("N")
        ->capture_default_str()
        ->check(wholeNumberFrom(1, maxSamples));
    app.add_option("--depth", options.encoding.depth, "Bits a sample of .png and .ppm")
        ->type_name("8|16")
        ->capture_default_str()
        ->check(CLI::Validator(CLI::IsMember({8, 16})).description(""));
    app.add_flag("--linear", options.encoding.linear, "Write .png and .ppm without the scene's gamma");
    app.add_flag("--half", options.encoding.half, "Write .exr with 16-bit floating point");
    app.add_flag("--big-endian", options.encoding.bigEndian,
                 "Write the size in .dmp with the high byte first");
    app.add_option("--allow-path", raw.allowedFolders,
                   "Folder besides the scene's own that the scene may read files from; may be repeated")
        ->type_name("DIR")
        ->allow_extra_args(false);
    app.add_option("--progress", raw.progress, "On standard error; auto: a bar on a terminal, else none")
        ->type_name("auto|bar|json|none")
        ->check(CLI::Validator(CLI::IsMember({"auto", "bar", "json", "none"})).description(""));
    app.add_option("--stats", raw.stats, "Write times, memory and numbers of rays, as JSON")
        ->type_name("FILE");
    app.add_option("--aov", raw.aov,
                   "Write what is known of each pixel besides its colour: body, depth, normal, shadows, ...")
        ->type_name("FILE.exr")
        ->check(CLI::Validator(checkAovFile, ""));
    app.add_option("--hits", raw.hits,
                   "Write what each pixel's ray meets, with all digits: body, distance, normal")
        ->type_name("FILE.csv");
    const auto checkpoint =
        app.add_option("--checkpoint", raw.checkpoint,
                       "Keep finished tiles in this file, so that an interrupted render can go on")
            ->type_name("FILE");
    app.add_flag("--resume", options.resume, "Go on from the checkpoint, if there is one")->needs(checkpoint);
    app.add_flag("--partial", options.partial,
                 "Render nothing: write what the checkpoint holds, and black where it holds nothing")
        ->needs(checkpoint);
    app.add_option("--diagnostics", raw.diagnostics, "How errors and warnings are printed")
        ->type_name("text|json")
        ->check(CLI::Validator(CLI::IsMember({"text", "json"})).description(""));
}

/// Throws CLI::ValidationError.
void complete(Options& options, const Raw& raw) {
    options.scene = raw.scene;
    options.outputs.assign(raw.outputs.begin(), raw.outputs.end());
    if (options.outputs.empty())
        options.outputs.push_back(options.scene.filename().replace_extension(".png"));
    if (!raw.size.empty()) options.size = parseSize(raw.size);
    if (!raw.region.empty()) options.region = parseRegion(raw.region);
    if (raw.precision == "fast") options.precision = Precision::inFloat;
    if (raw.threads) {
        options.mode = RenderMode::threads;
        options.workers = *raw.threads;
    } else if (raw.processes == 0) {
        options.mode = RenderMode::serial;
    } else {
        options.workers = raw.processes ? *raw.processes : availableCores();
    }
    options.allowedFolders.assign(raw.allowedFolders.begin(), raw.allowedFolders.end());
    if (raw.progress == "bar") options.progress = ProgressStyle::bar;
    if (raw.progress == "json") options.progress = ProgressStyle::json;
    if (raw.progress == "none") options.progress = ProgressStyle::none;
    if (!raw.stats.empty()) options.stats = raw.stats;
    if (!raw.aov.empty()) options.aov = raw.aov;
    if (!raw.hits.empty()) options.hits = raw.hits;
    if (!raw.checkpoint.empty()) options.checkpoint = raw.checkpoint;
    options.jsonDiagnostics = raw.diagnostics == "json";
}

} // namespace

ParsedOptions parseOptions(int argc, const char* const* argv) {
    CLI::App app("Renders a scene of the YARTE language by ray tracing.", "yarte");
    Raw raw;
    Options options;
    declare(app, raw, options);
    try {
        app.parse(argc, argv);
        complete(options, raw);
    } catch (const CLI::CallForHelp&) {
        return {std::nullopt, app.help(), 0};
    } catch (const CLI::CallForVersion& call) {
        return {std::nullopt, fmt::format("{}\n", call.what()), 0};
    } catch (const CLI::ParseError& error) {
        return {std::nullopt, fmt::format("yarte: {}\nSee yarte --help\n", error.what()), 2};
    }
    return {std::move(options), {}, 0};
}

} // namespace yarte
