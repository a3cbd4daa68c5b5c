#include "validate/options.h"

#include "yarte/version.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <functional>

namespace yarte::validate {

namespace {

/// "WxH" with W and H from 1; the renderers say what is too large.
std::string checkSize(const std::string& text) {
    const auto isCount = [](std::string_view digits) {
        return !digits.empty() && digits.size() <= 9 && digits.front() != '0' &&
               digits.find_first_not_of("0123456789") == std::string_view::npos;
    };
    const std::string_view view = text;
    const std::size_t x = view.find('x');
    if (x != std::string_view::npos && isCount(view.substr(0, x)) && isCount(view.substr(x + 1))) return {};
    return fmt::format("expected WxH, like 640x480, got '{}'", text);
}

/// A check without a text of its own in --help.
CLI::Validator quiet(CLI::Validator check) { return check.description(""); }

void declare(CLI::App& app, Options& options) {
    app.get_formatter()->column_width(26);
    app.set_version_flag("--version", fmt::format("yarte-validate {}", version),
                         "Print the version and exit");
    app.footer(
        "Exit codes: 0 all pass, 1 a picture differs, 2 wrong usage, 3 a case could not be decided,\n"
        "130 interrupted. A scene whose name is \"images\" or \"speed\" is given as ./images, ./speed.");
    app.add_option("SCENE", options.scenes, "Scenes to render")->type_name("");
    app.add_option("-o,--output", options.output, "Folder for the report and its images")
        ->type_name("DIR")
        ->required();
    app.add_option("--size", options.size, "Image size in pixels, instead of each scene's own")
        ->type_name("WxH")
        ->check(CLI::Validator(checkSize, ""));
    app.add_option("--processes", options.processes,
                   "Worker processes of yarte and threads of POV-Ray. Default: one per core")
        ->type_name("N")
        ->check(quiet(CLI::NonNegativeNumber));
    app.add_option("--jobs", options.jobs,
                   "Cases that run side by side; they share the cores unless --processes is given.\n"
                   "Default: one per core. With 1, times are those of a machine that does nothing else")
        ->type_name("N")
        ->check(quiet(CLI::PositiveNumber));
    app.add_option("--tolerance", options.tolerance,
                   "Tolerance of all cases (JSON). Default: tolerance.json beside each scene, else 4/65535")
        ->type_name("FILE");
    app.add_option("--cache", options.cache, "Folder where POV-Ray's pictures are kept, to be used again")
        ->type_name("DIR");
    CLI::Option* const baseline = app.add_option("--baseline", options.baseline,
                                                 "Compare with the pictures kept there, not with POV-Ray's")
                                      ->type_name("DIR");
    app.add_flag("--update-baseline", options.updateBaseline,
                 "Put the new pictures there and say what changed")
        ->needs(baseline);
    app.add_option("--time-limit", options.timeLimit, "Seconds that each program may run")
        ->type_name("S")
        ->capture_default_str()
        ->check(quiet(CLI::Range(0.1, 1e6)));
    app.add_option("--yarte", options.yarte, "The renderer. Default: beside this program, then in PATH")
        ->type_name("FILE");
    app.add_option("--convert", options.convert, "The converter, yarte-convert. Default: as for --yarte")
        ->type_name("FILE");
    app.add_option("--povray", options.povray, "POV-Ray. Default: in PATH")->type_name("FILE");
    app.add_option_function<std::string>(
           "--diagnostics", [&](const std::string& style) { options.jsonDiagnostics = style == "json"; },
           "How errors are printed")
        ->type_name("text|json")
        ->check(quiet(CLI::IsMember({"text", "json"})));
}

CLI::App& declareImages(CLI::App& app, Options& options) {
    CLI::App& images =
        *app.add_subcommand("images", "Compare two image files of any format OpenImageIO reads");
    images.fallthrough();
    images.add_option("A", options.imageA, "An image")->required()->type_name("");
    images.add_option("B", options.imageB, "The reference")->required()->type_name("");
    images.add_flag_callback(
        "--srgb", [&] { options.integers = Encoding::srgb; },
        "Integers are sRGB encoded. Default: they are linear, as floating-point numbers always are");
    return images;
}

CLI::App& declareSpeed(CLI::App& app, Options& options, SpeedOptions& speed, bool& noTessellation) {
    CLI::App& command = *app.add_subcommand("speed", "Measure speed against error, in diagrams");
    command.fallthrough();
    command.get_formatter()->column_width(26);
    command.footer(
        "-o, --size, --processes (1 unless it is given), --time-limit and the programs' places are as\n"
        "for comparisons: see yarte-validate --help. Exit codes: 0 measured, 2 wrong usage, 3 a scene\n"
        "could not be measured, 130 interrupted.");
    command.add_option("SCENE", options.scenes, "Scenes to measure")->required()->type_name("");
    command.add_option("--samples", speed.samples, "Rays a pixel, N x N, of the pictures")
        ->type_name("N,...")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->default_str(fmt::format("{}", fmt::join(speed.samples, ",")))
        ->check(quiet(CLI::Range(1, 255)));
    command.add_option("--reference", speed.referenceSamples, "Rays a pixel, N x N, of the reference")
        ->type_name("N")
        ->capture_default_str()
        ->check(quiet(CLI::Range(2, 256)));
    command.add_option("--runs", speed.runs, "Runs of each program; times are medians")
        ->type_name("N")
        ->capture_default_str()
        ->check(quiet(CLI::Range(1, 1000)));
    command.add_option("--rays", speed.rays, "Single rays compared with the truth, at most; 0: none")
        ->type_name("N")
        ->capture_default_str()
        ->check(quiet(CLI::Range(0, 1'000'000)));
    command
        .add_option("--chord-errors", speed.chordErrors,
                    "Of triangles for curved shapes, in parts of the largest radius")
        ->type_name("E,...")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->default_str(fmt::format("{}", fmt::join(speed.chordErrors, ",")))
        ->check(quiet(CLI::Range(1e-6, 1.0)));
    command.add_flag("--no-tessellation", noTessellation, "Measure no triangles for curved shapes");
    command.add_flag("--no-povray", speed.noPovray, "Measure YARTE only");
    return command;
}

template <class Number, class Less>
void sortOnce(std::vector<Number>& numbers, Less less) {
    std::sort(numbers.begin(), numbers.end(), less);
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

/// Throws CLI::ValidationError.
void complete(Options& options, SpeedOptions speed, bool areSamplesGiven, bool noTessellation) {
    if (!areSamplesGiven) std::erase_if(speed.samples, [&](int n) { return n >= speed.referenceSamples; });
    sortOnce(speed.samples, std::less<>());
    sortOnce(speed.chordErrors, std::greater<>());
    if (speed.samples.back() >= speed.referenceSamples)
        throw CLI::ValidationError(
            "--samples", fmt::format("must be below those of the reference, {}", speed.referenceSamples));
    if (noTessellation) speed.chordErrors.clear();
    if (speed.noPovray && !options.povray.empty())
        throw CLI::ValidationError("--no-povray", "and --povray contradict each other");
    if (options.processes == 0)
        throw CLI::ValidationError("--processes", "must be at least 1: POV-Ray has as many threads");
    const auto refuse = [](const char* name, bool isGiven) {
        if (isGiven) throw CLI::ValidationError(name, "is for comparisons, not for speed");
    };
    refuse("--jobs", options.jobs.has_value());
    refuse("--tolerance", !options.tolerance.empty());
    refuse("--cache", !options.cache.empty());
    refuse("--baseline", !options.baseline.empty());
    options.speed = std::move(speed);
}

} // namespace

ParsedOptions parseOptions(int argc, const char* const* argv) {
    CLI::App app("Renders scenes with YARTE and with POV-Ray and compares the pictures in linear light.\n"
                 "A case passes if no pixel differs by more than 4/65535.",
                 "yarte-validate");
    Options options;
    declare(app, options);
    const CLI::App& images = declareImages(app, options);
    SpeedOptions speedOptions;
    bool noTessellation = false;
    const CLI::App& speed = declareSpeed(app, options, speedOptions, noTessellation);
    try {
        app.parse(argc, argv);
        if (images.parsed() && !options.scenes.empty())
            throw CLI::ValidationError("images", "compares two files and takes no scenes");
        if (images.parsed() && !options.baseline.empty())
            throw CLI::ValidationError("--baseline", "is for scenes, not for images");
        if (speed.parsed())
            complete(options, std::move(speedOptions), speed.count("--samples") > 0, noTessellation);
        if (!images.parsed() && options.scenes.empty()) throw CLI::RequiredError("SCENE");
    } catch (const CLI::CallForHelp&) {
        return {std::nullopt,
                images.parsed()  ? images.help("yarte-validate")
                : speed.parsed() ? speed.help("yarte-validate")
                                 : app.help(),
                0};
    } catch (const CLI::CallForVersion& call) {
        return {std::nullopt, fmt::format("{}\n", call.what()), 0};
    } catch (const CLI::ParseError& error) {
        return {std::nullopt, fmt::format("yarte-validate: {}\nSee yarte-validate --help\n", error.what()),
                2};
    }
    return {std::move(options), {}, 0};
}

} // namespace yarte::validate
