// yarte: renders a scene. The only file of the program that prints, reads the environment or decides the exit
// code.
#include "convert/gltf/mesh_reader.h"
#include "yarte/aov_image.h"
#include "yarte/base/diagnostic.h"
#include "yarte/base/file.h"
#include "yarte/checkpoint.h"
#include "yarte/engine/memory_limit.h"
#include "yarte/engine/render.h"
#include "yarte/engine/tile_list.h"
#include "yarte/hits_text.h"
#include "yarte/interrupt.h"
#include "yarte/lang/pmf.h"
#include "yarte/lang/scene_reader.h"
#include "yarte/options.h"
#include "yarte/outputs.h"
#include "yarte/progress.h"
#include "yarte/stats.h"
#include "yarte/trace/camera_hits.h"
#include "yarte/trace/supersample.h"

#include <fmt/format.h>

#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <new>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include <unistd.h>

namespace yarte {
namespace {

enum ExitCode { good = 0, refused = 1, wrongUsage = 2, couldNotRun = 3 };

constexpr std::array meshFormats{MeshFormat{".pmf", readPmf}, MeshFormat{".gltf", convert::gltf::readMesh},
                                 MeshFormat{".glb", convert::gltf::readMesh}};

void print(std::FILE* stream, std::string_view text) {
    std::fwrite(text.data(), 1, text.size(), stream);
    std::fflush(stream);
}

class Stopwatch {
public:
    double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point start_ = Clock::now();
};

/// What `action` gives; a FileError of its says what could not be done.
template <class Action>
auto orCannot(std::string_view verb, Action action) {
    try {
        return action();
    } catch (const FileError& error) {
        throw std::runtime_error(fmt::format("cannot {} {}", verb, error.what()));
    }
}

/// Progress on standard error, ten times a second.
class ProgressPrinter {
public:
    explicit ProgressPrinter(ProgressStyle style) : style_(style) {
        if (style == ProgressStyle::automatic)
            style_ = isatty(STDERR_FILENO) ? ProgressStyle::bar : ProgressStyle::none;
    }
    ~ProgressPrinter() {
        if (style_ == ProgressStyle::bar) print(stderr, noProgressBar);
    }

    void update(RenderProgress progress) {
        const double now = watch_.seconds();
        if (printedDone_ == progress.total || (now - printedAt_ < 0.1 && progress.done < progress.total))
            return;
        printedAt_ = now;
        printedDone_ = progress.done;
        if (style_ == ProgressStyle::bar) print(stderr, progressBar(progress, now));
        if (style_ == ProgressStyle::json) print(stderr, progressJson(progress, now));
    }

private:
    ProgressStyle style_;
    Stopwatch watch_;
    double printedAt_ = 0;
    std::size_t printedDone_ = 0; ///< the end is printed once
};

/// One run: scene, world, picture, files.
class Run {
public:
    explicit Run(Options options) : options_(std::move(options)) {
        const char* const noColour = std::getenv("NO_COLOR");
        if (options_.jsonDiagnostics)
            style_ = DiagnosticStyle::json;
        else if (isatty(STDERR_FILENO) && !(noColour && *noColour))
            style_ = DiagnosticStyle::coloured;
    }

    int operator()();
    /// Says why the run ends, and returns `code`.
    int fail(int code, std::string message) const;

private:
    std::optional<Scene> read();
    WorldPtr build(const Scene&, Resolution);
    std::optional<Journal> openJournal(const Scene&, Resolution, Tile region);
    std::optional<Rendering> trace(const World&, const RenderOptions&);
    Rendering readJournal(Journal&, Tile region);
    void tellOfJournal(const Journal&, std::size_t damagedRecords);
    void write(Rendering&, double gamma);
    void writeAov(const Scene&, Resolution, const World*, const RenderOptions&);
    void writeHits(const Scene&, Resolution, const World*, Tile region);

    Options options_;
    Sources sources_;
    DiagnosticStyle style_ = DiagnosticStyle::plain;
    Stopwatch watch_;
    Stats stats_;
    bool isJournalFailureTold_ = false;
};

int Run::fail(int code, std::string message) const {
    if (style_ != DiagnosticStyle::json) {
        print(stderr, fmt::format("yarte: {}\n", message));
    } else {
        Diagnostics diagnostics;
        diagnostics.error(code == wrongUsage ? "yarte.wrong-usage" : "yarte.could-not-run",
                          std::move(message));
        print(stderr, format(diagnostics, Sources(), style_));
    }
    return code;
}

std::optional<Scene> Run::read() {
    const Stopwatch watch;
    Diagnostics diagnostics;
    const SceneReading reading{{options_.allowedFolders}, meshFormats};
    auto scene = orCannot("open", [&] { return readScene(options_.scene, reading, sources_, diagnostics); });
    print(stderr, format(diagnostics, sources_, style_));
    stats_.parseSeconds = watch.seconds();
    return scene;
}

WorldPtr Run::build(const Scene& scene, Resolution resolution) {
    const Stopwatch watch;
    WorldPtr world = buildWorld(scene, resolution, options_.precision);
    stats_.buildSeconds = watch.seconds();
    stats_.precision = precisionOf(*world);
    if (precisionOf(*world) != options_.precision) {
        Diagnostics diagnostics;
        diagnostics.warning("yarte.precision",
                            "float is too coarse for this scene at this size; traced in double");
        print(stderr, format(diagnostics, Sources(), style_));
    }
    return world;
}

std::optional<Journal> Run::openJournal(const Scene& scene, Resolution size, Tile region) {
    if (!options_.checkpoint) return std::nullopt;
    const std::filesystem::path& file = *options_.checkpoint;
    const std::vector<JournalItem> items =
        checkpointItems(options_, sources_[SourceId{0}], scene, size, region);
    const TileList tiles(region, *options_.tileSide);
    return orCannot("use the checkpoint", [&] {
        if (options_.partial) return Journal::look(file, items, tiles);
        std::error_code error;
        if (options_.resume && std::filesystem::exists(file, error))
            return Journal::resume(file, items, tiles);
        return Journal::create(file, items, tiles);
    });
}

Rendering Run::readJournal(Journal& journal, Tile region) {
    Rendering result{Framebuffer(region, *options_.tileSide), {}, 0, 0};
    const TileList tiles(region, *options_.tileSide);
    result.damagedRecords =
        journal.readTiles([&](std::size_t tile, const RayCounts& rays, const Colour* pixels) {
            result.framebuffer.put(tiles[tile], pixels);
            result.rays += rays;
        });
    return result;
}

/// What does not stop the render.
void Run::tellOfJournal(const Journal& journal, std::size_t damagedRecords) {
    Diagnostics diagnostics;
    if (damagedRecords > 0)
        diagnostics.warning("yarte.checkpoint-damaged",
                            fmt::format("{}: {} of its tiles were damaged, and are rendered again",
                                        options_.checkpoint->string(), damagedRecords));
    if (journal.failure() && !isJournalFailureTold_) {
        diagnostics.warning("yarte.checkpoint-full",
                            fmt::format("{}: {}; the render goes on, and what it finishes now is not kept",
                                        options_.checkpoint->string(), *journal.failure()));
        isJournalFailureTold_ = true;
    }
    print(stderr, format(diagnostics, sources_, style_));
}

std::optional<Rendering> Run::trace(const World& world, const RenderOptions& options) {
    const Stopwatch watch;
    ProgressPrinter printer(options_.progress);
    auto rendering = render(
        options,
        [&](Tile tile, Colour* pixels, std::size_t stride, TileCosts& costs) {
            supersample(options_.samples, tile, pixels, stride,
                        [&](Tile part, Colour* to, std::size_t toStride) {
                            if (options_.stats)
                                renderTileTimed(world, part, to, toStride, costs, costs.times);
                            else
                                renderTile(world, part, to, toStride, costs);
                        });
        },
        [&](RenderProgress progress) {
            printer.update(progress);
            if (options.journal) tellOfJournal(*options.journal, 0);
            return !DeferredInterrupts::pending();
        });
    stats_.traceSeconds = watch.seconds();
    return rendering;
}

void Run::write(Rendering& rendering, double gamma) {
    const Stopwatch watch;
    ImageEncoding encoding = options_.encoding;
    encoding.gamma = gamma;
    for (const std::filesystem::path& output : options_.outputs) {
        if (DeferredInterrupts::pending()) return;
        const std::string bytes = encodeImage(*imageFormat(output), rendering.framebuffer.rows(), encoding);
        orCannot("write", [&] { writeFile(output, bytes); });
    }
    stats_.writeSeconds = watch.seconds();
}

void Run::writeAov(const Scene& scene, Resolution resolution, const World* world,
                   const RenderOptions& options) {
    // They are always in double, in a world that is where the scene is, and of one ray a pixel.
    const bool suits = world && precisionOf(*world) == Precision::inDouble && options_.samples == 1;
    const WorldPtr own = suits ? nullptr : buildWorld(scene, resolution);
    const auto image = aovImage(scene, sources_, suits ? *world : *own, options,
                                [](RenderProgress) { return !DeferredInterrupts::pending(); });
    if (image) orCannot("write", [&] { writeFile(*options_.aov, encodeExrLayers(*image)); });
}

void Run::writeHits(const Scene& scene, Resolution resolution, const World* world, Tile region) {
    const bool suits = world && options_.samples == 1; // they are of one ray a pixel
    const WorldPtr own = suits ? nullptr : buildWorld(scene, resolution, options_.precision);
    const std::string text = hitsText(region, cameraHits(suits ? *world : *own, region));
    orCannot("write", [&] { writeFile(*options_.hits, text); });
}

int Run::operator()() {
    orCannot("write", [&] {
        for (const std::filesystem::path& output : options_.outputs) requireWritable(output);
        if (options_.stats) requireWritable(*options_.stats);
        if (options_.aov) requireWritable(*options_.aov);
        if (options_.hits) requireWritable(*options_.hits);
    });
    if (const auto why = overwritesScene(options_)) return fail(wrongUsage, *why);
    if (const auto why = checkpointInTheWay(options_)) return fail(wrongUsage, *why);

    const std::optional<Scene> scene = read();
    if (!scene) return refused;
    const Resolution resolution = options_.size.value_or(scene->resolution);
    const Tile region = options_.region.value_or(Tile{0, 0, resolution.width, resolution.height});
    if (region.x1 > resolution.width || region.y1 > resolution.height)
        return fail(wrongUsage,
                    fmt::format("--region: {},{},{},{} is not within the image of {}x{} pixels", region.x0,
                                region.y0, region.x1, region.y1, resolution.width, resolution.height));
    if (const auto why = tooLargeForOutput(options_, region.width(), region.height()))
        return fail(wrongUsage, *why);
    if (const auto why = imageTooLarge(region.width(), region.height(), memoryLimit()))
        return fail(couldNotRun, *why);

    // A checkpoint's tiles do not depend on how many work, which may be others when it is resumed.
    if (!options_.tileSide)
        options_.tileSide = suitableTileSide(region, options_.checkpoint ? 1 : options_.workers);

    const DeferredInterrupts deferred; // from here on there are workers to end and files to finish
    const Resolution rays{resolution.width * options_.samples, resolution.height * options_.samples};
    std::optional<Journal> journal = openJournal(*scene, resolution, region);
    const RenderOptions options{region, *options_.tileSide, options_.mode, options_.workers,
                                journal ? &*journal : nullptr};
    const WorldPtr world = options_.partial ? nullptr : build(*scene, rays);
    std::optional<Rendering> rendering = world ? trace(*world, options) : readJournal(*journal, region);
    if (rendering && journal) tellOfJournal(*journal, rendering->damagedRecords);
    if (rendering) write(*rendering, scene->gamma);
    if (rendering && options_.aov) writeAov(*scene, resolution, world.get(), options);
    if (rendering && options_.hits) writeHits(*scene, resolution, world.get(), region);
    if (const int signal = DeferredInterrupts::pending())
        return fail(interruptExitCode(signal), "interrupted");

    if (options_.stats) {
        stats_.scene = options_.scene.string();
        stats_.width = region.width();
        stats_.height = region.height();
        stats_.mode = options_.mode;
        stats_.workers = rendering->workers;
        stats_.rays = rendering->rays;
        stats_.times = rendering->times;
        stats_.peakRssBytes = peakRssBytes();
        stats_.wallSeconds = watch_.seconds();
        orCannot("write", [&] { writeFile(*options_.stats, toJson(stats_)); });
    }
    return good;
}

int runProgram(int argc, char** argv) {
    installInterruptHandlers();
    letLargeWritesFail();
    ParsedOptions parsed = parseOptions(argc, argv);
    if (!parsed.options) {
        print(parsed.exitCode == good ? stdout : stderr, parsed.text);
        return parsed.exitCode;
    }
    Run run(std::move(*parsed.options));
    try {
        return run();
    } catch (const JournalError& error) {
        return run.fail(refused, error.what());
    } catch (const std::bad_alloc&) {
        return run.fail(couldNotRun, "not enough memory");
    } catch (const std::exception& error) {
        return run.fail(couldNotRun, error.what());
    }
}

} // namespace
} // namespace yarte

int main(int argc, char** argv) { return yarte::runProgram(argc, argv); }
